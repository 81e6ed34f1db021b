// Whether what was drawn is what was approved, and who is to blame when it is not.
#pragma once

#include "golden/approvals.h"
#include "golden/scene_table.h"
#include "render/image_difference.h"

namespace ember::golden {

/// A scene as it is now.
struct Drawn {
    std::uint64_t parameters = 0, state = 0;  ///< hashes
    Image image;
    Environment environment;
    Work work;
};

enum class Outcome {
    Exact,     ///< tier 1: an approved picture, to the bit
    Close,     ///< tier 2: in an environment without an approved picture, within close_limits
    Missing,   ///< there is no golden
    Solver,    ///< the state is another, so that its picture says nothing about the renderer
    Renderer,  ///< the state is the same and the picture is not
};

struct Verdict {
    Outcome outcome = Outcome::Missing;
    ImageDifference difference;  ///< from the picture beside the file, if there is one
    std::string text;            ///< one line
    /// Counters that are higher than recorded, one line each. Counts of the renderer are only
    /// compared in an approved environment.
    std::vector<std::string> more_work;

    [[nodiscard]] bool looks_right() const {
        return outcome == Outcome::Exact || outcome == Outcome::Close;
    }
    [[nodiscard]] bool good() const { return looks_right() && more_work.empty(); }
};

/// What tier 2 takes for the same picture.
[[nodiscard]] DifferenceLimits close_limits(const Scene& scene);

/// `golden` and `expected` may be null. State first, then pixels: by hash where the environment is
/// approved, and only there; else by hash or, failing that, by close_limits.
[[nodiscard]] Verdict judge(const Scene& scene, const Drawn& drawn, const Golden* golden,
                            const Image* expected);

/// The golden that results from approving `drawn`, judged as `verdict`: beside the earlier
/// approvals, up to three, where it is the same drawing in another environment; else instead of
/// them.
[[nodiscard]] Golden approve(const Drawn& drawn, const Verdict& verdict, const Golden* golden,
                             const std::string& reason, const std::string& commit);

}  // namespace ember::golden
