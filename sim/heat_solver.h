// Three ways to conduct heat over a time dt, all conserving Σ C T:
//
//   FTCS  explicit; stable and an average (nothing overshoots) for dt <= 1 / most_per_capacity.
//         First order in time. The paper's.
//   RKL2  super-time-stepping (Meyer, Balsara & Aslam 2014): s explicit stages reach a step of
//         (s² + s - 2)/4 explicit ones. Second order.
//   ADI   Peaceman & Rachford 1955: half a step implicit along rows and explicit across, half a
//         step the other way round. Stable for any dt, second order.
//
// RKL2 and ADI are checked: where a step leaves the range of the temperatures it started from by
// more than rounding (they are not averages), it is done again by monotone_step().
#pragma once

#include "sim/heat_conduction.h"
#include "sim/heat_lines.h"
#include "sim/heat_tiles.h"
#include "sim/params.h"
#include "sim/step_stats.h"

namespace ember {

/// Scratch of ADI.
struct AdiScratch {
    LineFactors model_row, model_column;  ///< of the lines that most are like
    LineFactors own_rows, own_columns;    ///< of a strip with a line unlike them
    double k = -1;                        ///< [s] that the model factors are for
    std::uint64_t topology_version = ~0ull;
    std::vector<double> explicit_part;    ///< [K] of a strip of rows, by row
    std::vector<double> lanes;            ///< [K] the same, by column
    std::vector<double> largest;          ///< [K] largest |u| of every column
    std::vector<std::uint8_t> warm_rows;  ///< per tile row
    std::vector<double> solved;           ///< [K] a strip of rows after its solve, by row
};

/// Scratch of one sheet.
struct HeatScratch {
    Conduction conduction;
    HeatTiles tiles;
    HeatField next, stage, slope;  ///< what solvers write; RKL2 needs all three
    std::vector<double> row_rate;  ///< [K/s] of one row
    AdiScratch adi;
};

/// One problem: the sheet's temperature [K], N, is advanced in place (vectors may be swapped).
struct HeatStep {
    std::vector<double>& temperature;
    double ambient;  ///< [K] cold regions are exactly at it
    bool skip;       ///< leave out cold regions; never changes a bit of the result
    HeatScratch& scratch;
    StepCounters& counters;
};

/// `count` explicit steps of h [s]. A region at ambient has differences of exactly 0 and stays as
/// it is, so tiles without heat that none can reach are skipped.
void ftcs(const HeatStep& step, double h, std::int64_t count);

/// One super step of h [s]; skips as FTCS does. Odd s, at least 3.
void rkl2(const HeatStep& step, double h);
[[nodiscard]] std::int64_t rkl2_stages(double explicit_steps);

/// One step of h [s].
void adi(const HeatStep& step, double h);

/// h [s] by FTCS where that takes at most 64 sub-steps, else by one locally one-dimensional step of
/// backward Euler: first order, an average for any h.
void monotone_step(const HeatStep& step, double h);

/// The locally one-dimensional step of backward Euler by itself.
void implicit_euler(const HeatStep& step, double h);

/// Explicit steps that h [s] takes.
[[nodiscard]] double explicit_steps(const Conduction& op, double h);

}  // namespace ember
