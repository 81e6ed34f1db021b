// Solvers of other libraries behind one signature.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problem.h"

namespace ember::peers {

/// One method of one library. solve() takes y from t = 0 to `duration` [s] with `setting`, which is
/// a step [s] of methods with fixed steps or a tolerance (absolute and relative) of the others;
/// returns false when the library reports a failure.
struct PeerMethod {
    std::string library, name;
    bool fixed_step = false;
    std::function<bool(RightHandSide& f, std::vector<double>& y, double duration, double setting)>
        solve;
};

[[nodiscard]] std::vector<PeerMethod> odeint_methods();
[[nodiscard]] std::vector<PeerMethod> sundials_methods();

}  // namespace ember::peers
