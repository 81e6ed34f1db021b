#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/blackbody.h"

namespace ember {
namespace {

struct Stop {
    double at;
    float r, g, b;
};

Colour between_stops(std::span<const Stop> stops, double x) {
    const auto colour = [](const Stop& s) { return Colour(s.r, s.g, s.b); };
    if (x <= stops.front().at) return colour(stops.front());
    for (std::size_t i = 1; i < stops.size(); ++i) {
        if (x > stops[i].at) continue;
        const auto t = static_cast<float>((x - stops[i - 1].at) / (stops[i].at - stops[i - 1].at));
        return (1 - t) * colour(stops[i - 1]) + t * colour(stops[i]);
    }
    return colour(stops.back());
}

// Char is (22, 20, 18) of 255 in sRGB; the brown band is narrow.
constexpr Stop kScorch[] = {{0.0, 0.0080f, 0.0070f, 0.0060f}, {0.8, 0.0130f, 0.0095f, 0.0070f},
                            {1.8, 0.050f, 0.027f, 0.012f},    {3.0, 0.180f, 0.095f, 0.040f},
                            {4.5, 0.420f, 0.280f, 0.140f},    {7.0, 0.660f, 0.550f, 0.390f},
                            {12.0, 0.790f, 0.740f, 0.620f},   {20.0, 0.845f, 0.815f, 0.740f},
                            {32.0, 0.860f, 0.840f, 0.780f}};

constexpr Stop kAsh[] = {
    {0.0, 0.060f, 0.058f, 0.056f}, {0.5, 0.27f, 0.265f, 0.255f}, {1.0, 0.54f, 0.535f, 0.52f}};

// The line is brightest where air reaches the hot char first, and fades behind.
constexpr Stop kEmber[] = {{0.0, 0.0f, 0.0f, 0.0f},     {0.12, 1.6f, 0.30f, 0.02f},
                           {0.35, 6.4f, 2.30f, 0.36f},  {0.60, 4.2f, 1.15f, 0.12f},
                           {0.95, 1.3f, 0.20f, 0.012f}, {1.6, 0.25f, 0.022f, 0.001f},
                           {2.6, 0.05f, 0.004f, 0.0f},  {4.0, 0.0f, 0.0f, 0.0f}};

constexpr Stop kHeat[] = {{0.00, 0.002f, 0.001f, 0.012f}, {0.20, 0.090f, 0.008f, 0.150f},
                          {0.40, 0.330f, 0.018f, 0.130f}, {0.60, 0.720f, 0.085f, 0.035f},
                          {0.80, 0.950f, 0.380f, 0.020f}, {1.00, 0.975f, 0.960f, 0.420f}};

constexpr Stop kMass[] = {{0.00, 0.058f, 0.001f, 0.090f},
                          {0.25, 0.042f, 0.085f, 0.255f},
                          {0.50, 0.015f, 0.275f, 0.262f},
                          {0.75, 0.105f, 0.560f, 0.130f},
                          {1.00, 0.980f, 0.800f, 0.020f}};

constexpr Stop kStress[] = {{0.00, 0.010f, 0.040f, 0.210f},
                            {0.25, 0.075f, 0.240f, 0.560f},
                            {0.50, 0.780f, 0.780f, 0.750f},
                            {0.75, 0.560f, 0.155f, 0.080f},
                            {1.00, 0.175f, 0.010f, 0.025f}};

}  // namespace

Colour scorched_albedo(double ahead) {
    return between_stops(kScorch, ahead);
}
Colour ember_light(double behind) {
    return between_stops(kEmber, behind);
}
Colour char_albedo() {
    return scorched_albedo(0);
}
Colour ash_albedo(double pale) {
    return between_stops(kAsh, pale);
}
Colour flame_colour(double u) {
    // Soot glows like a black body. Of 1300 to 1900 K daylight film would show red to orange only;
    // eyes in a dark room see yellow, so the scale reaches higher.
    const double x = std::clamp(u, 0.0, 1.0);
    const double brightness = 3.6 * std::pow(x, 2.0);
    return static_cast<float>(brightness) * blackbody_colour(1550.0 + 1450.0 * x * x);
}
Colour heat_map(double x) {
    return between_stops(kHeat, x);
}
Colour mass_map(double x) {
    return between_stops(kMass, x);
}

Colour stress_map(double x) {
    return between_stops(kStress, x);
}

Colour spring_colour(SpringColour kind) {
    switch (kind) {
        case SpringColour::Main:
            return {0.08f, 0.30f, 0.95f};
        case SpringColour::Cross:
            return {0.95f, 0.20f, 0.45f};
        case SpringColour::Diagonal:
            return {0.75f, 0.60f, 0.06f};
        case SpringColour::Bending:
            return {0.35f, 0.36f, 0.40f};
        case SpringColour::Burning:
            return {2.2f, 0.75f, 0.08f};
    }
    return Colour::Zero();
}

Colour phase_colour(Phase phase) {
    switch (phase) {
        case Phase::Unburnt:
            return {0.80f, 0.78f, 0.70f};
        case Phase::Burning:
            return {0.90f, 0.22f, 0.02f};
        case Phase::BurntOut:
            return {0.05f, 0.06f, 0.10f};
    }
    return Colour::Zero();
}

ColourTable tabulate(Colour (*function)(double), double end) {
    ColourTable table;
    for (int i = 0; i < kTableSize; ++i) {
        table[static_cast<std::size_t>(i)] = function(end * i / (kTableSize - 1));
    }
    return table;
}

}  // namespace ember
