#include "sim/world_state.h"

#include <bit>
#include <type_traits>

#include "sim/random.h"

namespace ember {
namespace {

// Mixes values one after the other; every bit of every value matters, and so does the order.
struct Hasher {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;

    void add(std::uint64_t bits) { h = mix(h ^ bits); }

    template <class T>
    void operator()(const char*, const T& value) {
        put(value);
    }

  private:
    void put(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void put(std::uint64_t value) { add(value); }
    void put(std::int64_t value) { add(static_cast<std::uint64_t>(value)); }
    void put(Index value) { add(static_cast<std::uint32_t>(value)); }
    void put(std::uint8_t value) { add(value); }
    void put(Phase value) { add(static_cast<std::uint64_t>(value)); }
    void put(const Quad& quad) {
        for (const Index node : quad)
            put(node);
    }
    template <class T>
    void put(const std::vector<T>& array) {
        add(array.size());
        for (const T& value : array)
            put(value);
    }
};

}  // namespace

std::uint64_t hash_of(const WorldState& state) {
    Hasher hasher;
    hasher.add(state.sheets.size());
    for_each_field(state, hasher);
    return hasher.h;
}

}  // namespace ember
