#include "sim/wind.h"

#include <cmath>

#include "sim/math.h"

namespace ember {

Vector3 wind_velocity(const WindParams& wind, double time) {
    constexpr double kTwoPi = 6.283185307179586;
    const Vector3 mean(wind.x, wind.y, wind.z);
    if (wind.gust == 0 || mean == Vector3::Zero()) return mean;
    const double turns = time / wind.gust_period;
    const double within = turns - std::floor(turns);  // the sine is ours, for moderate angles
    return mean * (1.0 + wind.gust * ember::sin(kTwoPi * within));
}

}  // namespace ember
