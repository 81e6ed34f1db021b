// The strip test of flame spread: a strip of paper held by its two long edges, one short edge lit.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sim/params.h"

namespace ember {

/// Which way the front has to go.
enum class Spread : std::uint8_t { Horizontal, Up, Down };
inline constexpr std::array<std::string_view, 3> kSpreadNames = {"horizontal", "up", "down"};

/// When the front passed a place.
struct FrontPoint {
    double distance, time;  // [m] from the lit edge, [s]
};

/// Straight line of distance against time through the points, by least squares.
struct FrontFit {
    double speed = 0;      ///< [m/s]
    double r_squared = 0;  ///< [1] share of the variance that the line explains
};

/// Needs at least two points at different times; else both results are 0.
[[nodiscard]] FrontFit fit_front(std::span<const FrontPoint> points);

/// What one strip did, measured over the middle half of its width and between 30 and 80 % of its
/// length, where neither the cold held edges nor the lit one matter.
struct StripRun {
    FrontFit front;
    double spread_rate = 0;    ///< [kg/(m s)] front speed times grammage
    double reached = 0;        ///< [1] share of the length that the front passed
    double band = 0;           ///< [m] mean width of what burns while the front is in the part
    double burn_time = 0;      ///< [s] mean, of nodes that have burnt out
    double residual_mass = 0;  ///< [1] mean, of nodes that have burnt out
    double shrink = 0;         ///< [1] mean, of structural springs between burnt-out nodes
    double mass_error = 0;     ///< [1] of mass(t) + burnt(t) against mass(0), the worst
    double energy_error = 0;   ///< [1] of the mechanical ledger, the worst
    double heat_error = 0;     ///< [1] of the heat ledger, the worst
    std::string failure;       ///< why a tick failed; empty: none did
    double duration = 0;       ///< [s] simulated
    double seconds = 0;        ///< processor time
};

/// Burns `grade` as a strip of 100 mm x 300 mm in square cells of `cell` [m], its long edges held,
/// on the calling thread, until what is measured has burnt out or the fire has died. The first
/// 25 mm start hot enough to ignite; the lighter of `grade` stays off.
[[nodiscard]] StripRun run_strip(const Params& grade, Spread spread, double cell);

}  // namespace ember
