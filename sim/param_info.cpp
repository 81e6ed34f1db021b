#include "sim/param_info.h"

#include <algorithm>

namespace ember {

void put_override(ParamOverrides& overrides, const ParamInfo& row, ParamValue value) {
    const auto at =
        std::lower_bound(overrides.begin(), overrides.end(), &row,
                         [](const ParamOverride& o, const ParamInfo* r) { return o.row < r; });
    if (at != overrides.end() && at->row == &row) {
        at->value = std::move(value);
    } else {
        overrides.insert(at, {&row, std::move(value)});
    }
}

}  // namespace ember
