#include "sim/heat_lines.h"

#include "sim/vectorise.h"

namespace ember {
namespace {

void resize(LineFactors& f, Index count, Index width, bool closed) {
    f.count = count;
    f.width = width;
    f.closed = closed;
    const auto entries = static_cast<std::size_t>(count) * static_cast<std::size_t>(width);
    f.lower.resize(entries);
    f.centre.resize(entries);
    f.upper.resize(entries);
    f.seam.resize(closed ? entries : 0);
    f.seam_last.resize(static_cast<std::size_t>(width));
}

// lower and upper hold k a and k b; they become the factors, with the diagonal made so that the
// corners of a closed line are of rank one: the first entry doubled, the last one less
// lower_0 upper_last / -first.
EMBER_VECTORISED
void eliminate(double* __restrict lower, double* __restrict centre, double* __restrict upper,
               double* __restrict seam, double* __restrict seam_last, Index count, Index width,
               bool closed) {
    const Index end = (count - 1) * width;
    for (Index j = 0; j < width; ++j) {
        const double first = 1.0 + lower[j] + upper[j];
        double last = 1.0 + lower[end + j] + upper[end + j];
        if (closed) {
            seam_last[j] = lower[j] / first;
            last += lower[j] * upper[end + j] / first;
            for (Index i = 0; i < count; ++i)
                seam[i * width + j] = 0;
            seam[j] = -first;
            seam[end + j] = -upper[end + j];
        }
        centre[j] = 1.0 / (closed ? first + first : first);
        centre[end + j] = last;
    }
    for (Index i = 0; i < count; ++i) {
        for (Index j = 0; j < width; ++j) {
            const Index at = i * width + j;
            if (i == 0) {
                lower[at] = 0;
            } else {
                const double whole = i + 1 < count ? 1.0 + lower[at] + upper[at] : centre[at];
                centre[at] = 1.0 / (whole - lower[at] * upper[at - width]);
                lower[at] = lower[at] * centre[at];
            }
            upper[at] = i + 1 < count ? upper[at] * centre[at] : 0.0;
        }
    }
}

EMBER_VECTORISED
void sweep_shared(const double* lower, const double* centre, const double* upper, Index count,
                  double* __restrict x, std::size_t stride, Index lines) {
    for (Index j = 0; j < lines; ++j)
        x[j] = centre[0] * x[j];
    for (Index i = 1; i < count; ++i) {
        double* __restrict now = x + static_cast<std::size_t>(i) * stride;
        const double* before = now - stride;
        const double a = lower[i], m = centre[i];
        for (Index j = 0; j < lines; ++j)
            now[j] = m * now[j] + a * before[j];
    }
    for (Index i = count - 2; i >= 0; --i) {
        double* __restrict now = x + static_cast<std::size_t>(i) * stride;
        const double* after = now + stride;
        const double b = upper[i];
        for (Index j = 0; j < lines; ++j)
            now[j] = now[j] + b * after[j];
    }
}

EMBER_VECTORISED
void sweep_own(const double* lower, const double* centre, const double* upper, Index count,
               double* __restrict x, std::size_t stride, Index lines) {
    for (Index j = 0; j < lines; ++j)
        x[j] = centre[j] * x[j];
    for (Index i = 1; i < count; ++i) {
        double* __restrict now = x + static_cast<std::size_t>(i) * stride;
        const double* before = now - stride;
        const double* a = lower + i * lines;
        const double* m = centre + i * lines;
        for (Index j = 0; j < lines; ++j)
            now[j] = m[j] * now[j] + a[j] * before[j];
    }
    for (Index i = count - 2; i >= 0; --i) {
        double* __restrict now = x + static_cast<std::size_t>(i) * stride;
        const double* after = now + stride;
        const double* b = upper + i * lines;
        for (Index j = 0; j < lines; ++j)
            now[j] = now[j] + b[j] * after[j];
    }
}

void sweep(const LineFactors& f, double* x, std::size_t stride, Index lines) {
    if (f.width == 1) {
        sweep_shared(f.lower.data(), f.centre.data(), f.upper.data(), f.count, x, stride, lines);
    } else {
        sweep_own(f.lower.data(), f.centre.data(), f.upper.data(), f.count, x, stride, lines);
    }
}

void factor(LineFactors& f) {
    eliminate(f.lower.data(), f.centre.data(), f.upper.data(), f.seam.data(), f.seam_last.data(),
              f.count, f.width, f.closed);
    if (!f.closed) return;
    const auto width = static_cast<std::size_t>(f.width);
    sweep(f, f.seam.data(), width, f.width);
    const std::size_t end = static_cast<std::size_t>(f.count - 1) * width;
    for (std::size_t j = 0; j < width; ++j) {
        const double scale = 1.0 / (1.0 + f.seam[j] + f.seam_last[j] * f.seam[end + j]);
        for (std::size_t i = j; i <= end + j; i += width)
            f.seam[i] *= scale;
    }
}

}  // namespace

void factor_rows(const Conduction& op, Index first, Index width, double k, LineFactors& f) {
    resize(f, op.column_count, width, false);
    for (Index j = 0; j < width; ++j) {
        const std::size_t at = op.row_begin(first + j);
        auto to = static_cast<std::size_t>(j);
        double left = 0;
        for (std::size_t c = 0; c < static_cast<std::size_t>(op.column_count); ++c) {
            const double per = k * op.per_capacity[at + c];
            f.lower[to] = left * per;
            left = op.main[at + c];
            f.upper[to] = left * per;
            to += static_cast<std::size_t>(width);
        }
    }
    factor(f);
}

void factor_columns(const Conduction& op, Index first, Index width, double k, LineFactors& f) {
    resize(f, op.row_count, width, op.closed);
    std::size_t to = 0;
    for (Index row = 0; row < op.row_count; ++row) {
        const std::size_t at = op.row_begin(row);
        const double* above = op.cross_above(row);
        for (Index j = 0; j < width; ++j, ++to) {
            const auto c = static_cast<std::size_t>(first + j);
            const double per = k * op.per_capacity[at + c];
            f.lower[to] = above[c] * per;
            f.upper[to] = op.cross[at + c] * per;
        }
    }
    factor(f);
}

EMBER_VECTORISED
void correct_seam(const double* seam, const double* seam_last, Index count, Index width, double* x,
                  std::size_t stride, Index lines) {
    for (Index j = 0; j < lines; ++j) {
        const Index own = width == 1 ? 0 : j;
        const auto last = static_cast<std::size_t>(count - 1) * stride;
        const double s = x[j] + seam_last[own] * x[last + static_cast<std::size_t>(j)];
        if (s == 0) continue;
        for (Index i = 0; i < count; ++i) {
            double& at = x[static_cast<std::size_t>(i) * stride + static_cast<std::size_t>(j)];
            at = at - seam[i * width + own] * s;
        }
    }
}

void solve_lines(const LineFactors& f, double* x, std::size_t stride, Index lines) {
    sweep(f, x, stride, lines);
    if (!f.closed) return;
    correct_seam(f.seam.data(), f.seam_last.data(), f.count, f.width, x, stride, lines);
}

}  // namespace ember
