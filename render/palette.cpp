#include "render/palette.h"

#include <algorithm>
#include <span>

namespace ember {
namespace {

constexpr double kScorchStart = 393.15;  // [K] paper begins to yellow

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

constexpr Stop kAlbedo[] = {{0.00, 0.86f, 0.84f, 0.78f},    {0.15, 0.80f, 0.73f, 0.58f},
                            {0.35, 0.48f, 0.33f, 0.17f},    {0.60, 0.13f, 0.070f, 0.030f},
                            {0.85, 0.022f, 0.016f, 0.012f}, {1.00, 0.010f, 0.009f, 0.009f},
                            {2.00, 0.012f, 0.012f, 0.012f}, {2.25, 0.020f, 0.020f, 0.021f},
                            {3.00, 0.130f, 0.129f, 0.127f}, {4.00, 0.300f, 0.296f, 0.288f}};

// The rim is narrow and bright where a point has just ignited; behind it embers fade.
constexpr Stop kGlow[] = {
    {0.84, 0.0f, 0.0f, 0.0f},      {0.94, 0.9f, 0.13f, 0.010f},   {1.02, 3.4f, 1.15f, 0.17f},
    {1.10, 2.0f, 0.44f, 0.04f},    {1.20, 0.45f, 0.062f, 0.005f}, {1.40, 0.085f, 0.010f, 0.001f},
    {2.00, 0.035f, 0.0035f, 0.0f}, {2.35, 0.010f, 0.001f, 0.0f},  {2.60, 0.0f, 0.0f, 0.0f}};

constexpr Stop kFlame[] = {{0.00, 0.000f, 0.000f, 0.000f}, {0.12, 0.010f, 0.001f, 0.000f},
                           {0.25, 0.070f, 0.012f, 0.002f}, {0.45, 0.340f, 0.095f, 0.012f},
                           {0.65, 1.050f, 0.450f, 0.060f}, {0.85, 2.000f, 1.150f, 0.220f},
                           {1.00, 2.600f, 1.850f, 0.520f}};

constexpr Stop kHeat[] = {{0.00, 0.002f, 0.001f, 0.012f}, {0.20, 0.090f, 0.008f, 0.150f},
                          {0.40, 0.330f, 0.018f, 0.130f}, {0.60, 0.720f, 0.085f, 0.035f},
                          {0.80, 0.950f, 0.380f, 0.020f}, {1.00, 0.975f, 0.960f, 0.420f}};

constexpr Stop kMass[] = {{0.00, 0.058f, 0.001f, 0.090f},
                          {0.25, 0.042f, 0.085f, 0.255f},
                          {0.50, 0.015f, 0.275f, 0.262f},
                          {0.75, 0.105f, 0.560f, 0.130f},
                          {1.00, 0.980f, 0.800f, 0.020f}};

}  // namespace

double burn_progress(Phase phase, double temperature, double ignition, double burnt, double age) {
    switch (phase) {
        case Phase::Unburnt:
            return std::clamp((temperature - kScorchStart) / (ignition - kScorchStart), 0.0, 1.0);
        case Phase::Burning:
            return 1.0 + std::clamp(burnt, 0.0, 1.0);
        case Phase::BurntOut:
            return std::min(2.0 + age / kAshTime, kBurnProgressEnd);
    }
    return 0.0;
}

Colour paper_albedo(double p) {
    return between_stops(kAlbedo, p);
}
Colour paper_glow(double p) {
    return p < kGlow[0].at ? Colour::Zero() : between_stops(kGlow, p);
}
Colour flame_colour(double u) {
    return between_stops(kFlame, u);
}
Colour heat_map(double x) {
    return between_stops(kHeat, x);
}
Colour mass_map(double x) {
    return between_stops(kMass, x);
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
