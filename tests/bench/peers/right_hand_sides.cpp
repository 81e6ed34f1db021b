// One evaluation of the accelerations, written in four ways.
#include <cmath>

#include "measure.h"
#include "swing_problem.h"
#include "tables.h"
#include "tests/reference/mass_spring.h"

namespace ember::peers {
namespace {

// Some smooth motion, away from rest in every spring.
void deform(test::Rig& rig) {
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        const Vector3 x = rig.sheet.position.at(n);
        const Vector3 phase(31 * x.x() + 17 * x.z(), 23 * x.x() - 29 * x.z(), 19 * x.z() + x.x());
        rig.sheet.position.set(n, x + 0.002 * phase.array().sin().matrix());
        rig.sheet.velocity.set(n, 0.3 * phase.array().cos().matrix());
    }
}

// Largest difference to `expected`, over its largest value.
double difference(const std::vector<double>& a, const std::vector<double>& expected) {
    double most = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(a[i] - expected[i]));
        largest = std::max(largest, std::abs(expected[i]));
    }
    return most / largest;
}

void compare(int rows, int columns, int repeats, std::FILE* csv) {
    test::Rig exact = make_swing(rows, columns, Arithmetic::Exact);
    test::Rig fast = make_swing(rows, columns, Arithmetic::Fast);
    deform(exact);
    deform(fast);
    const std::size_t n = exact.sheet.mass.size();
    const std::vector<double> y = state_of(exact);
    const double *x = y.data(), *v = y.data() + 3 * n;
    const auto edges = reference::make_mass_springs(exact.lattice, exact.sheet, exact.params);
    const PlainProblem problem = translate(exact);
    PlainStencil stencil(problem);
    const Mechanics in_exact = exact.mechanics(), in_fast = fast.mechanics();

    std::vector<Vector3> by_edges;
    std::vector<double> by_stencil(3 * n), by_exact(3 * n), by_fast(3 * n), listed(3 * n);
    const int calls = static_cast<int>(2'000'000 / n) + 1;
    const auto repeated = [calls](auto&& work) {
        return [calls, work] {
            for (int i = 0; i < calls; ++i)
                work();
        };
    };
    const std::vector<double> times =
        interleaved({repeated([&] { reference::accelerations(edges, by_edges); }),
                     repeated([&] { stencil.accelerate(x, v, by_stencil.data()); }),
                     repeated([&] { (void)accelerate(in_exact, x, v, by_exact.data()); }),
                     repeated([&] { (void)accelerate(in_fast, x, v, by_fast.data()); })},
                    4 * repeats + 1);
    for (std::size_t i = 0; i < n; ++i) {
        for (Index axis = 0; axis < 3; ++axis)
            listed[static_cast<std::size_t>(axis) * n + i] = by_edges[i][axis];
    }
    const char* names[] = {"edge list", "plain stencil", "emberleaf exact", "emberleaf fast"};
    const std::vector<double>* results[] = {&listed, &by_stencil, &by_exact, &by_fast};
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double per_node = times[i] / calls / static_cast<double>(n) * 1e9;
        const double error = difference(*results[i], listed);
        std::printf("%4d x %-4d %-16s %8.2f ns/node   %6.2f %6.2f   %.1e\n", rows, columns,
                    names[i], per_node, times[0] / times[i], times[1] / times[i], error);
        if (csv != nullptr) {
            std::fprintf(csv, "rhs,%dx%d,%s,%.4g,,,%.3g\n", rows, columns, names[i], per_node,
                         error);
        }
    }
}

}  // namespace

void compare_right_hand_sides(int repeats, std::FILE* csv) {
    std::printf(
        "One right-hand side; times faster than the edge list and than the plain stencil;\n"
        "largest difference of the accelerations to the edge list's, over the largest.\n");
    if (csv != nullptr) {
        std::fprintf(csv, "table,who,method,seconds_or_ns,setting,evaluations,error\n");
    }
    compare(32, 48, repeats, csv);
    compare(128, 192, repeats, csv);
}

}  // namespace ember::peers
