// Parameters that change over time, between keys.
#pragma once

#include <string>
#include <vector>

#include "render/view_params.h"
#include "sim/params.h"
#include "sim/world.h"

namespace ember {

/// One parameter over time. Numbers pass smoothly through their keys without overshooting (a
/// monotone cubic, on the logarithm where the row's scale is one); integers, toggles and choices
/// stay until the next key. Before the first key and after the last one, the value is that key's.
class Track {
  public:
    /// `times` [s] ascending, `values` in SI; as many of each, at least one.
    Track(const ParamInfo& row, std::vector<double> times, std::vector<double> values);
    [[nodiscard]] double at(double time) const;
    [[nodiscard]] const ParamInfo& row() const { return *row_; }

  private:
    const ParamInfo* row_;
    bool smooth_, logarithmic_;
    std::vector<double> times_, values_, slopes_;
};

class Keyframes {
  public:
    /// Reads "KEY=TIME:VALUE,TIME:VALUE" (seconds; values as in a preset, in the shown unit).
    /// Throws InputError, also for keys that only a restart of the scene can change.
    void add(const std::string& text);

    [[nodiscard]] bool empty() const { return texts_.empty(); }
    /// Whether any track is of the simulation rather than of how it is looked at.
    [[nodiscard]] bool move_simulation() const { return !sim_.empty(); }
    /// Sets what the tracks say at `time` [s].
    void apply(Params& params, double time) const;
    void apply(RenderParams& params, double time) const;
    /// Gives `world` the parameters of its time, before a tick.
    void apply(World& world) const;
    /// As given, one track a line.
    [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

  private:
    std::vector<Track> sim_, render_;
    std::vector<std::string> texts_;
};

}  // namespace ember
