#include "sim/param_table.h"

#include <algorithm>
#include <array>

#include "sim/scene.h"
#include "sim/table/burning_rows.h"
#include "sim/table/fracture_rows.h"
#include "sim/table/numerics_rows.h"
#include "sim/table/paper_rows.h"
#include "sim/table/sheet_rows.h"
#include "sim/table/surroundings_rows.h"

namespace ember {
namespace {

using namespace param_rows;

template <std::size_t... N>
constexpr auto join(const ParamInfo (&... parts)[N]) {
    std::array<ParamInfo, (N + ...)> all{};
    std::size_t next = 0;
    const auto append = [&](const auto& part) {
        for (const ParamInfo& row : part)
            all[next++] = row;
    };
    (append(parts), ...);
    return all;
}

// In the order in which people should meet them.
constexpr auto kRows =
    join(kPaperRows, kSheetRows, kSurroundingsRows, kBurningRows, kFractureRows, kNumericsRows);

static_assert(row_count(kRows, "paper") == field_count<PaperParams>, "every field needs a row");
static_assert(row_count(kRows, "sheet") == field_count<SheetParams>, "every field needs a row");
static_assert(row_count(kRows, "springs") == field_count<SpringParams>, "every field needs a row");
static_assert(row_count(kRows, "plate") == field_count<PlateParams>, "every field needs a row");
static_assert(row_count(kRows, "curl") == field_count<CurlParams>, "every field needs a row");
static_assert(row_count(kRows, "world") == field_count<WorldParams>, "every field needs a row");
static_assert(row_count(kRows, "wind") == field_count<WindParams>, "every field needs a row");
static_assert(row_count(kRows, "hand") == field_count<HandParams>, "every field needs a row");
static_assert(row_count(kRows, "contact") == field_count<ContactParams>, "every field needs a row");
static_assert(row_count(kRows, "heat") == field_count<HeatParams>, "every field needs a row");
static_assert(row_count(kRows, "burning") == field_count<BurningParams>, "every field needs a row");
static_assert(row_count(kRows, "fire") == field_count<FireParams>, "every field needs a row");
static_assert(row_count(kRows, "lighter") == field_count<LighterParams>, "every field needs a row");
static_assert(row_count(kRows, "shrinkage") == field_count<ShrinkageParams>,
              "every field needs a row");
static_assert(row_count(kRows, "fracture") == field_count<FractureParams>,
              "every field needs a row");
static_assert(row_count(kRows, "numerics") == field_count<NumericsParams>,
              "every field needs a row");
static_assert(field_count<Params> == 15 + 4, "every group needs rows and an assertion above");

}  // namespace

std::span<const ParamInfo> sim_param_rows() {
    return kRows;
}

ParamBinding bind(Params& params) {
    return {kRows,
            &params,
            {{"sheets", "sheet", &params.sheets}, {"lighters", "lighter", &params.lighters}}};
}

ParamChange compare(const Params& a, const Params& b) {
    ParamChange change = a.lighters == b.lighters ? ParamChange::None : ParamChange::Live;
    if (a.sheets != b.sheets || a.masks != b.masks) return ParamChange::Rebuild;
    for (const ParamInfo& row : kRows) {
        if (row.value(&a) == row.value(&b)) continue;
        if (row.applies == ParamApplies::Rebuild) return ParamChange::Rebuild;
        change = ParamChange::Live;
    }
    return change;
}

std::vector<std::string> plausibility_warnings(const Params& params) {
    std::vector<std::string> warnings;
    const auto warn_if = [&](bool condition, const char* text) {
        if (condition) warnings.emplace_back(text);
    };
    warn_if(params.heat.flame_limit <= params.burning.ignition,
            "heat.flame_limit is not above burning.ignition: nothing can ignite");
    warn_if(params.fire.life_max < params.fire.life_min,
            "fire.life_max is below fire.life_min: particles live between the two all the same");
    const auto loose = [](const SheetParams& sheet) {
        return sheet.held == HeldEdge::None && sheet.held_points.empty();
    };
    const std::vector<SheetParams> sheets = sheets_of(params);
    warn_if(std::all_of(sheets.begin(), sheets.end(), loose) && params.world.gravity > 0,
            "sheet.held is none: the sheet falls at once");
    warn_if((params.wind.x != 0 || params.wind.y != 0 || params.wind.z != 0) &&
                params.world.air_drag == 0,
            "world.air_drag is 0: the wind does not move the paper");
    const double held_gravity = params.world.gravity_while_held();
    warn_if(held_gravity / params.springs.stiffness_scale > 0.1,
            "gravity over springs.stiffness_scale is above 0.1 m/s^2: the sheet hangs like rubber; "
            "raise the scale or lower world.held_gravity");
    warn_if(params.numerics.safety > 1,
            "numerics.safety is above 1: sub-steps may be unstable and will be rolled back");
    return warnings;
}

}  // namespace ember
