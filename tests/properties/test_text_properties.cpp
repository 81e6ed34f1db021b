// What is written reads back, and the order in which things are said does not matter.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "../app/preset_rig.h"
#include "app/exit_code.h"
#include "app/frame_list.h"
#include "property.h"
#include "ui/camera_text.h"

namespace ember {
namespace {

using test::expect_property;
using test::number_in;

// Any allowed value of a row [shown unit].
double any_value(const ParamInfo& row) {
    const double most = std::min(row.hard.max, row.hard.min + 1e6);
    const double value = number_in(row.hard.min, most);
    return row.kind == ParamKind::Real ? value : std::floor(value);
}

// Some rows of both tables changed to anything that is allowed.
Everything any_values() {
    Everything e;
    for (const ParamBinding& binding : e.bindings()) {
        for (const ParamInfo& row : binding.rows) {
            if (row.is_number() && *rc::gen::inRange(0, 8) == 0)
                row.set_shown(binding.object, any_value(row));
        }
    }
    return e;
}

std::string text_of(Everything& values) {
    return preset_text(values.bindings(), {});
}

TEST(TextProperties, APresetIsWhatItsTextReadsAs) {
    const TemporaryFolder folder;
    expect_property([&] {
        Everything values = any_values();
        const std::string text = text_of(values);
        Loaded again = load(folder.write("p.toml", text));
        RC_ASSERT(again.result.ok());
        RC_ASSERT(text_of(again.values) == text);
    });
}

// Groups are TOML tables; whichever comes first, the values are the same.
TEST(TextProperties, TheOrderOfThePresetsGroupsDoesNotMatter) {
    const TemporaryFolder folder;
    expect_property([&] {
        Everything values = any_values();
        const std::string text = text_of(values);
        std::vector<std::string> groups;
        std::size_t begin = text.find("\n[");
        const std::string top = text.substr(0, begin);
        while (begin != std::string::npos) {
            const std::size_t end = text.find("\n[", begin + 1);
            groups.push_back(text.substr(begin, end - begin));
            begin = end;
        }
        RC_ASSERT(groups.size() > 5);
        std::string shuffled = top;
        for (std::size_t left = groups.size(); left > 0; --left) {
            const std::size_t i = *rc::gen::inRange<std::size_t>(0, left);
            shuffled += groups[i];
            std::swap(groups[i], groups[left - 1]);
        }
        Loaded again = load(folder.write("p.toml", shuffled + '\n'));
        RC_ASSERT(again.result.ok());
        RC_ASSERT(text_of(again.values) == text);
    });
}

TEST(TextProperties, AnOverrideSetsWhatItSays) {
    expect_property([] {
        Everything e;
        Everything wanted;
        const std::size_t table = *rc::gen::inRange<std::size_t>(0, 2);
        const auto rows = e.bindings()[table].rows;
        const ParamInfo& row = rows[*rc::gen::inRange<std::size_t>(0, rows.size())];
        RC_PRE(row.kind == ParamKind::Real || row.kind == ParamKind::Integer);
        const double value = any_value(row);
        std::ostringstream text;
        text.precision(17);
        text << row.key << '=' << value;
        for (const Diagnostic& d : apply_override(text.str(), e.bindings()))
            RC_ASSERT(d.severity == Diagnostic::Severity::Warning);
        row.set_shown(wanted.bindings()[table].object, value);
        RC_ASSERT(text_of(e) == text_of(wanted));
    });
}

// A part of a list of frames, and the frames that it stands for.
std::string any_part(std::vector<long>& frames) {
    const long first = *rc::gen::inRange<long>(0, 2000), count = *rc::gen::inRange<long>(1, 30);
    const long step = *rc::gen::inRange<long>(1, 9);
    if (count == 1) {
        frames.push_back(first);
        return std::to_string(first);
    }
    for (long i = 0; i < count; ++i)
        frames.push_back(first + i * step);
    const long last = first + (count - 1) * step + *rc::gen::inRange<long>(0, step);
    const std::string range = std::to_string(first) + ".." + std::to_string(last);
    return step == 1 && *rc::gen::arbitrary<bool>() ? range : range + '+' + std::to_string(step);
}

TEST(TextProperties, FrameListsAreTheUnionOfTheirPartsInAnyOrder) {
    expect_property([] {
        std::vector<long> frames;
        std::vector<std::string> parts;
        const int count = *rc::gen::inRange(1, 8);
        for (int i = 0; i < count; ++i)
            parts.push_back(any_part(frames));
        const auto joined = [&] {
            std::string text;
            for (const std::string& part : parts)
                text += (text.empty() ? "" : ",") + part;
            return text;
        };
        const std::string in_order = joined();
        std::ranges::reverse(parts);
        std::ranges::sort(frames);
        frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
        RC_ASSERT(parse_frames(in_order) == frames);
        RC_ASSERT(parse_frames(joined()) == frames);
        std::string listed;
        for (const long frame : frames)
            listed += (listed.empty() ? "" : ",") + std::to_string(frame);
        RC_ASSERT(parse_frames(listed) == frames);
    });
}

TEST(TextProperties, TimesAreThoseOfTheirTextInOrder) {
    expect_property([] {
        std::vector<double> times;
        std::string text;
        const int count = *rc::gen::inRange(1, 12);
        for (int i = 0; i < count; ++i) {
            times.push_back(number_in(0, 1e4));
            std::array<char, 32> digits{};
            std::snprintf(digits.data(), digits.size(), "%.17g", times.back());
            text += (i == 0 ? "" : ",") + std::string(digits.data());
        }
        std::ranges::sort(times);
        RC_ASSERT(parse_times(text) == times);
        RC_ASSERT_THROWS_AS(static_cast<void>(parse_times(text + ",-1")), InputError);
    });
}

TEST(TextProperties, TextThatIsNoListIsRefusedAndNothingElse) {
    expect_property([] {
        const auto text =
            *rc::gen::container<std::string>(rc::gen::elementOf(std::string("0123456789.,+- x")));
        try {
            const std::vector<long> frames = parse_frames(text);
            RC_ASSERT(!frames.empty() && frames.front() >= 0);
            RC_ASSERT(std::ranges::is_sorted(frames));
        } catch (const InputError&) {  // the only other end
        }
    });
}

TEST(TextProperties, ACameraIsWhatItsTextReadsAs) {
    expect_property([] {
        RenderParams render;
        for (const ParamInfo& row : bind(render).rows) {
            if (row.group() == "camera" && row.is_number()) row.set_shown(&render, any_value(row));
        }
        const std::string text = camera_text(render.camera);
        const std::optional<CameraParams> again = camera_from_text(text);
        RC_ASSERT(again.has_value());
        RC_ASSERT(camera_text(*again) == text);
    });
}

}  // namespace
}  // namespace ember
