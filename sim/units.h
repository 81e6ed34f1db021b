// Units at the border of the program: SI inside, these outside.
#pragma once

#include <string_view>

namespace ember {

/// A unit that people may write. SI value = shown value * scale + offset.
struct Unit {
    std::string_view name;       ///< as shown and as written in a preset string, e.g. "g/m^2"
    std::string_view dimension;  ///< units of one dimension convert into each other
    double scale = 1.0;
    double offset = 0.0;

    // 18 mm are 18 / 1000 m to the last bit; 18 * 1e-3 is not, because 1e-3 is no binary fraction
    [[nodiscard]] constexpr double to_si(double shown) const {
        return (scale < 1.0 ? shown / (1.0 / scale) : shown * scale) + offset;
    }
    [[nodiscard]] constexpr double from_si(double si) const {
        return scale < 1.0 ? (si - offset) * (1.0 / scale) : (si - offset) / scale;
    }
};

namespace unit {
inline constexpr Unit one{"", "number"};
inline constexpr Unit percent{"%", "number", 1e-2};
inline constexpr Unit metre{"m", "length"};
inline constexpr Unit centimetre{"cm", "length", 1e-2};
inline constexpr Unit millimetre{"mm", "length", 1e-3};
inline constexpr Unit second{"s", "time"};
inline constexpr Unit millisecond{"ms", "time", 1e-3};
inline constexpr Unit hertz{"1/s", "rate"};
inline constexpr Unit per_minute{"1/min", "rate", 1.0 / 60.0};
inline constexpr Unit degree{"deg", "angle", 0.017453292519943295};
inline constexpr Unit radian{"rad", "angle"};
inline constexpr Unit celsius{"degC", "temperature", 1.0, 273.15};
inline constexpr Unit kelvin{"K", "temperature"};
inline constexpr Unit kelvin_per_second{"K/s", "heating rate"};
inline constexpr Unit gram_per_square_metre{"g/m^2", "grammage", 1e-3};
inline constexpr Unit kilogram_per_square_metre{"kg/m^2", "grammage"};
inline constexpr Unit kilogram_per_cubic_metre{"kg/m^3", "density"};
inline constexpr Unit gram_per_cubic_centimetre{"g/cm^3", "density", 1e3};
inline constexpr Unit gram_per_second_square_metre{"g/(s m^2)", "mass flux", 1e-3};
inline constexpr Unit kilogram_per_second_square_metre{"kg/(s m^2)", "mass flux"};
inline constexpr Unit joule_per_kilogram_kelvin{"J/(kg K)", "specific heat"};
inline constexpr Unit kilojoule_per_kilogram_kelvin{"kJ/(kg K)", "specific heat", 1e3};
inline constexpr Unit watt_per_metre_kelvin{"W/(m K)", "conductivity"};
inline constexpr Unit watt_per_square_metre_kelvin{"W/(m^2 K)", "heat transfer"};
inline constexpr Unit per_kelvin{"1/K", "expansion"};
inline constexpr Unit gigapascal{"GPa", "stress", 1e9};
inline constexpr Unit megapascal{"MPa", "stress", 1e6};
inline constexpr Unit newton_millimetre{"N mm", "flexural rigidity", 1e-3};
inline constexpr Unit newton_metre{"N m", "flexural rigidity"};
inline constexpr Unit kilopascal{"kPa", "stress", 1e3};
inline constexpr Unit metre_per_second{"m/s", "velocity"};
inline constexpr Unit metre_per_second_squared{"m/s^2", "acceleration"};
inline constexpr Unit per_second_squared{"1/s^2", "specific stiffness"};
inline constexpr Unit per_second_square_metre{"1/(s m^2)", "emission"};
}  // namespace unit

static_assert(unit::millimetre.to_si(18.0) == 0.018 && unit::per_minute.to_si(60.0) == 1.0);

/// Every unit that a preset string may end in.
inline constexpr Unit kUnits[] = {unit::one,
                                  unit::percent,
                                  unit::metre,
                                  unit::centimetre,
                                  unit::millimetre,
                                  unit::second,
                                  unit::millisecond,
                                  unit::hertz,
                                  unit::per_minute,
                                  unit::degree,
                                  unit::radian,
                                  unit::celsius,
                                  unit::kelvin,
                                  unit::kelvin_per_second,
                                  unit::gram_per_square_metre,
                                  unit::kilogram_per_square_metre,
                                  unit::kilogram_per_cubic_metre,
                                  unit::gram_per_cubic_centimetre,
                                  unit::gram_per_second_square_metre,
                                  unit::kilogram_per_second_square_metre,
                                  unit::joule_per_kilogram_kelvin,
                                  unit::kilojoule_per_kilogram_kelvin,
                                  unit::watt_per_metre_kelvin,
                                  unit::watt_per_square_metre_kelvin,
                                  unit::per_kelvin,
                                  unit::gigapascal,
                                  unit::megapascal,
                                  unit::newton_millimetre,
                                  unit::newton_metre,
                                  unit::kilopascal,
                                  unit::metre_per_second,
                                  unit::metre_per_second_squared,
                                  unit::per_second_squared,
                                  unit::per_second_square_metre};

}  // namespace ember
