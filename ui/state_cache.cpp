#include "ui/state_cache.h"

#include <utility>

namespace ember {

std::size_t bytes_of(const WorldState& state) {
    std::size_t bytes = sizeof state;
    for_each_field(state, [&](const char*, const auto& field) {
        if constexpr (requires { field.data(); }) bytes += field.size() * sizeof *field.data();
    });
    return bytes;
}

void StateCache::put(SharedState state) {
    const std::uint64_t tick = state->tick;
    if (tick % interval_ != 0 || states_.contains(tick)) return;
    const std::size_t size = bytes_of(*state);
    states_[tick] = {std::move(state), size};
    bytes_ += size;
    while (bytes_ > budget_ && states_.size() > 2) {
        interval_ *= 2;
        for (auto it = states_.begin(); it != states_.end();) {
            if (it->first % interval_ == 0) {
                ++it;
                continue;
            }
            bytes_ -= it->second.bytes;
            it = states_.erase(it);
        }
    }
}

SharedState StateCache::at(std::uint64_t tick) const {
    const auto found = states_.find(tick);
    return found == states_.end() ? nullptr : found->second.state;
}

SharedState StateCache::at_or_before(std::uint64_t tick) const {
    const auto after = states_.upper_bound(tick);
    return after == states_.begin() ? nullptr : std::prev(after)->second.state;
}

void StateCache::drop_after(std::uint64_t tick) {
    for (auto it = states_.upper_bound(tick); it != states_.end(); it = states_.erase(it))
        bytes_ -= it->second.bytes;
}

void StateCache::clear() {
    states_.clear();
    bytes_ = 0;
    interval_ = 1;
}

}  // namespace ember
