// An axis of a chart: from values to places, and where to write numbers.
#pragma once

#include <string>
#include <vector>

namespace ember {

enum class AxisScale { Linear, Logarithmic };

struct AxisTick {
    double value;
    std::string label;  ///< empty: a fine line without a number
};

/// Maps [low, high] to [0, 1].
class ChartAxis {
  public:
    /// Covers all finite `values` (positive ones on a logarithmic axis) with a little room on both
    /// sides; `from_zero` starts a linear axis at 0.
    ChartAxis(AxisScale scale, const std::vector<double>& values, bool from_zero = false);

    [[nodiscard]] double share(double value) const;
    /// Whether the axis can show `value` at all.
    [[nodiscard]] bool covers(double value) const;
    /// In increasing order, at most about ten with labels.
    [[nodiscard]] std::vector<AxisTick> ticks() const;

  private:
    [[nodiscard]] std::vector<AxisTick> decades() const;
    [[nodiscard]] std::vector<AxisTick> even_steps() const;
    AxisScale scale_;
    double low_ = 0, high_ = 1;  // log10 of the ends on a logarithmic axis
};

}  // namespace ember
