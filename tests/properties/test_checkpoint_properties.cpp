// Any state is what its bytes read as.
#include <bit>

#include "app/checkpoint_format.h"
#include "property.h"

namespace ember {
namespace {

using test::expect_property;

// Fills every field with any bits: numbers that are none as well.
struct Filler {
    template <class T>
    void operator()(const char*, T& value) {
        fill(value);
    }
    void fill(double& value) {
        value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    }
    void fill(Phase& value) { value = static_cast<Phase>(*rc::gen::inRange(0, 3)); }
    void fill(Quad& quad) {
        for (Index& node : quad)
            fill(node);
    }
    template <std::integral T>
    void fill(T& value) {
        value = *rc::gen::arbitrary<T>();
    }
    template <class T>
    void fill(std::vector<T>& array) {
        array.resize(*rc::gen::inRange<std::size_t>(0, 6));
        for (T& value : array)
            fill(value);
    }
};

WorldState any_state() {
    WorldState state;
    state.sheets.resize(*rc::gen::inRange<std::size_t>(0, 4));
    for (SheetState& sheet : state.sheets) {
        sheet.cracks.due.resize(*rc::gen::inRange<std::size_t>(0, 2));
        sheet.rest_curvature.main.resize(*rc::gen::inRange<std::size_t>(0, 2));
    }
    for_each_field(state, Filler{});
    return state;
}

TEST(CheckpointProperties, AStateIsWhatItsBytesReadAs) {
    expect_property([](std::uint64_t parameters, const std::string& program) {
        const WorldState state = any_state();
        const std::string bytes = saved_bytes(program, parameters, state);
        const SavedState again = read_saved_bytes(bytes);
        RC_ASSERT(again.program == program);
        RC_ASSERT(again.parameters == parameters);
        RC_ASSERT(hash_of(again.state) == hash_of(state));
        RC_ASSERT(saved_bytes(program, parameters, again.state) == bytes);
    });
}

TEST(CheckpointProperties, AnyOtherBytesAreRefused) {
    const std::string bytes = saved_bytes("1.0", 7, WorldState());
    expect_property([&] {
        std::string other = bytes;
        const std::size_t at = *rc::gen::inRange<std::size_t>(0, bytes.size());
        const auto count = *rc::gen::inRange<std::size_t>(0, bytes.size() - at + 1);
        other.replace(at, count, *rc::gen::arbitrary<std::string>());
        RC_PRE(other != bytes);
        RC_ASSERT_THROWS_AS(static_cast<void>(read_saved_bytes(other)), std::runtime_error);
    });
}

}  // namespace
}  // namespace ember
