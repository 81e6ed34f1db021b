// Tridiagonal systems of ADI, several lines side by side so that the recurrences vectorise.
//
// Unknown i of a line: (1 + k (a_i + b_i)) x_i - k a_i x_{i-1} - k b_i x_{i+1} = r_i, with a and b
// the conductance per capacity towards the neighbours (0 at a cut or a border). In a closed line
// the first unknown is the last one's neighbour. All-zero right-hand sides give exact zeros.
#pragma once

#include <vector>

#include "sim/heat_conduction.h"

namespace ember {

/// Solves by elimination: y_i = centre_i r_i + lower_i y_{i-1}, x_i = y_i + upper_i x_{i+1}, and
/// around a seam Sherman & Morrison's correction x - seam_i · (x_0 + seam_last x_last).
/// width = 1: one line's factors, for any number of lines; else factors of `width` lines, entry i
/// of line j at i * width + j.
struct LineFactors {
    Index count = 0, width = 0;
    bool closed = false;
    std::vector<double> lower, centre, upper;
    std::vector<double> seam;
    std::vector<double> seam_last;  ///< per line
};

/// Factors of `width` rows from `first` on, or of `width` columns.
void factor_rows(const Conduction& op, Index first, Index width, double k, LineFactors& factors);
void factor_columns(const Conduction& op, Index first, Index width, double k, LineFactors& factors);

/// Solves `lines` systems in place; unknown i of line j at x[i * stride + j].
void solve_lines(const LineFactors& factors, double* x, std::size_t stride, Index lines);

}  // namespace ember
