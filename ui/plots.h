// Figures of the burn over its time.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "ui/picture_controls.h"
#include "ui/snapshot.h"

namespace ember {

/// What has been seen of a burn: one sample for each published state, ascending by tick.
class PlotData {
  public:
    static constexpr std::size_t kCurves = 6;
    static constexpr std::size_t kMostSamples = 20000;
    struct Sample {
        std::uint64_t tick;
        std::array<float, kCurves> values;
    };
    /// Adds what is new; a burn that begins anew or forks loses what came later.
    void add(const Snapshot& shot);
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

    struct Curve {
        std::string_view name, unit;
    };
    static constexpr std::array<Curve, kCurves> kNames = {{{"hottest", "\u00b0C"},
                                                           {"mass", "g"},
                                                           {"heat", "J"},
                                                           {"burning", "nodes"},
                                                           {"cuts", ""},
                                                           {"tick", "ms"}}};

  private:
    std::vector<Sample> samples_;
};

/// Draws all curves at the left of the picture.
void draw_plots(const PictureRect& picture, const PlotData& data, const Snapshot& shot);

}  // namespace ember
