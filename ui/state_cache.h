// States of a burn that is being looked at, kept so that a person can go back in time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

#include "sim/world_state.h"

namespace ember {

using SharedState = std::shared_ptr<const WorldState>;

/// Every state within a budget of memory; beyond it every second, then every fourth, ...: what
/// lies between can be simulated again, because the same state goes on to the same bits.
class StateCache {
  public:
    explicit StateCache(std::size_t budget) : budget_(budget) {}

    /// Keeps `state` if its tick is one of those that are kept.
    void put(SharedState state);
    /// The state of exactly that tick, or null.
    [[nodiscard]] SharedState at(std::uint64_t tick) const;
    /// The latest state that is not after `tick`, or null.
    [[nodiscard]] SharedState at_or_before(std::uint64_t tick) const;
    void drop_after(std::uint64_t tick);
    void clear();

    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return states_.size(); }
    /// Ticks from one kept state to the next.
    [[nodiscard]] std::uint64_t interval() const { return interval_; }

  private:
    struct Kept {
        SharedState state;
        std::size_t bytes;
    };
    std::size_t budget_, bytes_ = 0;
    std::uint64_t interval_ = 1;
    std::map<std::uint64_t, Kept> states_;
};

/// Memory that the arrays of a state take [bytes].
[[nodiscard]] std::size_t bytes_of(const WorldState& state);

}  // namespace ember
