// The state hash of every tick of a run, as a file: what a run was, to the last bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/world.h"

namespace ember {

/// The state hashes of a run, tick by tick.
class HashLog {
  public:
    /// An empty log for runs of `world`, whose arithmetic decides what its hashes are called.
    explicit HashLog(const World& world);
    /// What text() has written. Throws InputError with file and line.
    explicit HashLog(const std::filesystem::path& file);

    /// Appends the state that `world` is in; ticks must follow each other.
    void record(const World& world);
    /// A line "tick HASH-KIND", then one with tick and hash for each.
    [[nodiscard]] std::string text() const;

    /// Empty when `world` is as the log says; otherwise what differs, with file and line.
    [[nodiscard]] std::string difference(const World& world) const;
    [[nodiscard]] std::uint64_t last_tick() const { return first_ + hashes_.size() - 1; }

  private:
    std::string name_ = {};    // of the file
    std::string title_;        // the first line
    std::uint64_t first_ = 0;  // tick of the first hash
    std::vector<std::uint64_t> hashes_ = {};
};

}  // namespace ember
