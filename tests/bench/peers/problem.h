// The swing problem as peers see it: y' = f(y), y = (x, v), and nothing else of emberleaf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ember::peers {

/// Right-hand side of the swing problem for states y = (x | y | z | vx | vy | vz) of N nodes
/// [m], [m/s], followed by kPadding zeros whose derivatives are 0.
class RightHandSide {
  public:
    static constexpr std::size_t kPadding = 16;

    virtual ~RightHandSide() = default;
    /// dydt [m/s], [m/s²]; both arrays have 6N + kPadding elements.
    void operator()(const double* y, double* dydt) {
        ++evaluations;
        evaluate(y, dydt);
    }

    std::int64_t evaluations = 0;

  protected:
    virtual void evaluate(const double* y, double* dydt) = 0;
};

/// Constants of one spring kind on a lattice, row after row of anchors.
struct SpringField {
    int rows_ahead = 0, columns_ahead = 0;         ///< from end a to end b; columns may be -1
    std::vector<double> stiffness, damping, rest;  ///< [N/m], [kg/s], [m] per end a; 0 outside
};

/// The swing problem's data.
struct PlainProblem {
    int rows = 0, columns = 0;         ///< nodes
    std::vector<SpringField> springs;  ///< six kinds
    std::vector<double> inverse_mass;  ///< [1/kg], 0 for held nodes
    std::vector<double> load_y;        ///< [N]
};

/// The problem's accelerations [m/s²], 3N, as a competent user would write them for speed: dense
/// arrays, one vectorised loop per spring kind, forces kept per kind and gathered by the nodes.
class PlainStencil {
  public:
    explicit PlainStencil(const PlainProblem& problem);
    void accelerate(const double* x, const double* v, double* a);

  private:
    const PlainProblem& p_;
    std::ptrdiff_t pitch_;
    std::vector<std::vector<double>> force_;  ///< of each kind: x, y, z with a border of zeros
};

/// That, as a right-hand side.
[[nodiscard]] std::unique_ptr<RightHandSide> plain_right_hand_side(const PlainProblem& problem);

}  // namespace ember::peers
