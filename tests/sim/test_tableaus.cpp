// The coefficients of Runge-Kutta methods against the order conditions (Butcher 1963): a method is
// of order p if and only if every rooted tree t of at most p nodes has Σ_i b_i φ_i(t) = 1/γ(t),
// where φ_i is the product of Σ_j A_ij φ_j and γ is the number of nodes times the product of γ,
// both over the trees that remain without the root.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/integrators/tableau.h"

namespace ember {
namespace {

// What remains of a tree without its root, as numbers of trees in rising order.
using Forest = std::vector<std::size_t>;

struct Tree {
    int nodes = 1;
    double gamma = 1;
    Forest without_root;
};

// All rooted trees of up to `most` nodes, by their size.
class Trees {
  public:
    explicit Trees(int most) {
        trees_.push_back({});
        for (int nodes = 2; nodes <= most; ++nodes)
            grow(nodes, nodes - 1, {}, trees_.size());
    }

    [[nodiscard]] const std::vector<Tree>& all() const { return trees_; }

  private:
    // Adds the trees whose root bears `forest` and `missing` nodes more, in trees below `end` that
    // come no earlier than the last of the forest.
    void grow(int nodes, int missing, const Forest& forest, std::size_t end) {
        if (missing == 0) {
            Tree tree{nodes, static_cast<double>(nodes), forest};
            for (const std::size_t each : forest)
                tree.gamma *= trees_[each].gamma;
            trees_.push_back(tree);
            return;
        }
        for (std::size_t next = forest.empty() ? 0 : forest.back(); next < end; ++next) {
            if (trees_[next].nodes > missing) continue;
            Forest more = forest;
            more.push_back(next);
            grow(nodes, missing - trees_[next].nodes, more, end);
        }
    }

    std::vector<Tree> trees_;
};

double dot(const StageRow& p, const StageRow& q) {
    double sum = 0;
    for (std::size_t i = 0; i < kMostStages; ++i)
        sum += p[i] * q[i];
    return sum;
}

// The largest error of all conditions on weights b for trees of each size, 0 first.
std::vector<double> condition_errors(const Tableau& t, const StageRow& b, int most) {
    const Trees trees(most);
    std::vector<StageRow> phi;
    std::vector<double> worst(static_cast<std::size_t>(most) + 1, 0.0);
    for (const Tree& tree : trees.all()) {
        StageRow product;
        for (std::size_t i = 0; i < kMostStages; ++i) {
            product[i] = i < t.stages ? 1.0 : 0.0;
            for (const std::size_t each : tree.without_root)
                product[i] *= dot(t.a[i], phi[each]);
        }
        double& error = worst[static_cast<std::size_t>(tree.nodes)];
        error = std::max(error, std::abs(dot(b, product) - 1 / tree.gamma));
        phi.push_back(product);
    }
    return worst;
}

// Meets all conditions up to its order, and not those of the next.
void expect_order(const Tableau& t, const StageRow& b, int order) {
    const std::vector<double> errors = condition_errors(t, b, order + 1);
    for (int nodes = 1; nodes <= order; ++nodes)
        EXPECT_LT(errors[static_cast<std::size_t>(nodes)], 1e-14) << nodes << " nodes";
    EXPECT_GT(errors.back(), 1e-6);
}

StageRow of_the_estimate(const Tableau& t) {
    StageRow b = t.b;
    for (std::size_t i = 0; i < kMostStages; ++i)
        b[i] -= t.error[i];
    return b;
}

TEST(Tableaus, ThereAreAsManyTreesAsCayleyCounted) {
    std::vector<int> count(9, 0);
    const Trees trees(8);
    for (const Tree& tree : trees.all())
        ++count[static_cast<std::size_t>(tree.nodes)];
    EXPECT_EQ(count, (std::vector<int>{0, 1, 1, 2, 4, 9, 20, 48, 115}));
}

TEST(Tableaus, MeetTheConditionsOfTheirOrder) {
    expect_order(kRk4, kRk4.b, 4);
    expect_order(kDopri5, kDopri5.b, 5);
    expect_order(kButcher6, kButcher6.b, 6);
    expect_order(kRkf78, kRkf78.b, 8);
}

TEST(Tableaus, EstimateTheErrorByAMethodOfTheOrderBelow) {
    expect_order(kDopri5, of_the_estimate(kDopri5), kDopri5.error_order - 1);
    expect_order(kRkf78, of_the_estimate(kRkf78), kRkf78.error_order - 1);
}

}  // namespace
}  // namespace ember
