#include "sim/integrators/motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/vectorise.h"

namespace ember {
namespace {

EMBER_VECTORISED void add_one(double* out, const double* base, double a, const double* p,
                              std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        out[i] = base[i] + a * p[i];
}

EMBER_VECTORISED void add_two(double* out, const double* base, double a, const double* p, double b,
                              const double* q, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        out[i] = base[i] + a * p[i] + b * q[i];
}

EMBER_VECTORISED void add_four(double* out, const double* base, const std::array<Term, 4>& t,
                               std::ptrdiff_t count) {
    const double a = t[0].factor, b = t[1].factor, c = t[2].factor, d = t[3].factor;
    const double *p = t[0].values, *q = t[1].values, *r = t[2].values, *s = t[3].values;
    for (std::ptrdiff_t i = 0; i < count; ++i)
        out[i] = base[i] + a * p[i] + b * q[i] + c * r[i] + d * s[i];
}

// As many terms at once as there are left, so that the arrays are read once.
void combine_range(double* out, const double* base, std::span<const Term> terms,
                   std::ptrdiff_t begin, std::ptrdiff_t end) {
    const std::ptrdiff_t count = end - begin;
    double* to = out + begin;
    const double* from = base + begin;
    if (terms.empty() && to != from) std::copy_n(from, count, to);
    while (!terms.empty()) {
        if (terms.size() >= 4) {
            std::array<Term, 4> four{terms[0], terms[1], terms[2], terms[3]};
            for (Term& term : four)
                term.values += begin;
            add_four(to, from, four, count);
            terms = terms.subspan(4);
        } else if (terms.size() >= 2) {
            add_two(to, from, terms[0].factor, terms[0].values + begin, terms[1].factor,
                    terms[1].values + begin, count);
            terms = terms.subspan(2);
        } else {
            add_one(to, from, terms[0].factor, terms[0].values + begin, count);
            terms = terms.subspan(1);
        }
        from = to;
    }
}

constexpr std::size_t kMostTerms = 32;

}  // namespace

void Motion::resize(std::size_t node_count) {
    x.resize(3 * node_count + kMotionPadding);
    v.resize(3 * node_count + kMotionPadding);
}

void Motion::read(const SheetState& sheet) {
    const std::size_t n = sheet.position.size();
    resize(n);
    const auto copy = [n](const Vector3Array& from, std::vector<double>& to) {
        const auto at = [&](std::size_t i) { return to.begin() + static_cast<std::ptrdiff_t>(i); };
        std::copy(from.x.begin(), from.x.end(), at(0));
        std::copy(from.y.begin(), from.y.end(), at(n));
        std::copy(from.z.begin(), from.z.end(), at(2 * n));
        std::fill(at(3 * n), to.end(), 0.0);
    };
    copy(sheet.position, x);
    copy(sheet.velocity, v);
}

void Motion::write(SheetState& sheet) const {
    const std::size_t n = sheet.position.size();
    const auto copy = [n](const std::vector<double>& from, Vector3Array& to) {
        std::copy_n(from.data(), n, to.x.data());
        std::copy_n(from.data() + n, n, to.y.data());
        std::copy_n(from.data() + 2 * n, n, to.z.data());
    };
    copy(x, sheet.position);
    copy(v, sheet.velocity);
}

void combine(double* out, const double* base, std::span<const Term> terms, std::size_t count,
             ThreadPool& pool) {
    std::array<Term, kMostTerms> used{};
    std::size_t size = 0;
    for (const Term& term : terms) {
        if (term.factor != 0.0) used[size++] = term;
    }
    const std::span<const Term> kept(used.data(), size);
    // whole cache lines to each thread; a line is worth about as much as two springs
    const auto lines = static_cast<std::ptrdiff_t>((count + 7) / 8);
    pool.for_rows(lines, 2, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        combine_range(out, base, kept, 8 * begin,
                      std::min(8 * end, static_cast<std::ptrdiff_t>(count)));
    });
}

double root_mean_square(const double* values, std::size_t count) {
    std::array<double, kBlockColumns> sum{};
    std::size_t i = 0;
    for (; i + kBlockColumns <= count; i += kBlockColumns) {
        for (std::size_t lane = 0; lane < kBlockColumns; ++lane)
            sum[lane] += values[i + lane] * values[i + lane];
    }
    double total = 0.0;
    for (const double s : sum)
        total += s;
    for (; i < count; ++i)
        total += values[i] * values[i];
    return std::sqrt(3.0 * total / static_cast<double>(count));
}

}  // namespace ember
