// One property as one test: rapidcheck's verdict and its smallest counterexample, as googletest
// tells it.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <sstream>

namespace ember::test {

/// Tries `property`, a function of random arguments that fails by RC_ASSERT.
template <class Property>
void expect_property(Property property) {
    // a run by hand is as repeatable as one by ctest
    ::setenv("RC_PARAMS", "seed=1 max_success=100", 0);
    const rc::detail::TestResult result = rc::detail::checkTestable(property);
    if (result.is<rc::detail::SuccessResult>()) return;
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    ADD_FAILURE() << message.str();
}

/// A number in [low, high], ends included: in 1024 steps, so that it shrinks to a short one.
inline double number_in(double low, double high) {
    return low + (high - low) / 1024.0 * *rc::gen::inRange(0, 1025);
}

}  // namespace ember::test
