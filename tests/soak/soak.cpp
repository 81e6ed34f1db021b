// Burns and draws presets over and over, in one process and one GL context.
//
//   soak [--minutes N | --rounds N] [PRESET...]      default: an hour of four presets
#include <glad/gl.h>
#include <malloc.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "app/frame_source.h"
#include "app/run_options.h"
#include "render/offscreen_context.h"
#include "soak_table.h"

namespace {

using namespace ember;
using Clock = std::chrono::steady_clock;

constexpr int kTicks = 120, kTicksPerPicture = 6, kWidth = 320, kHeight = 180;

double milliseconds_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double resident_megabytes() {
    ::malloc_trim(0);  // what the allocator keeps for later has not leaked
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * 4096e-6;
}

// Every name is asked, since GL counts nothing; they are given out from 1 on.
int gl_objects() {
    constexpr GLuint kNames = 4096;
    int count = 0;
    for (GLuint name = 1; name < kNames; ++name) {
        count += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) +
                 glIsRenderbuffer(name) + glIsVertexArray(name) + glIsProgram(name) +
                 glIsShader(name) + glIsQuery(name) + glIsSampler(name);
    }
    return count;
}

// Burns and draws one preset, and adds up what it took [ms].
void burn(const std::string& preset, Renderer& renderer, SoakRound& round) {
    RunOptions options;
    options.preset = preset;
    const LoadedPreset loaded = load_run(options);
    World world = build_world(loaded, 1);
    FrameSource source(world, nullptr, {});
    FrameView frame;
    for (int tick = 0; tick < kTicks; ++tick) {
        const auto begin = Clock::now();
        if (!source.show((tick + 1) * world.tick_duration(), frame))
            throw std::runtime_error(preset + ": the simulation diverged");
        round.tick_ms += milliseconds_since(begin) / kTicks;
        if (tick % kTicksPerPicture != 0) continue;
        const auto drawn = Clock::now();
        static_cast<void>(
            renderer.draw_image({&frame.view, frame.springs}, loaded.render, kWidth, kHeight));
        round.picture_ms += milliseconds_since(drawn) * kTicksPerPicture / kTicks;
    }
    char hash[24];
    std::snprintf(hash, sizeof hash, "%016llx ", static_cast<unsigned long long>(world.hash()));
    round.hashes += hash;
}

int soak(double minutes, std::size_t most_rounds, const std::vector<std::string>& presets) {
    const auto context = OffscreenContext::create(GlBackend::OsMesa);
    Renderer renderer(context->loader());
    std::vector<SoakRound> rounds;
    const auto begin = Clock::now();
    const auto count = static_cast<double>(presets.size());
    do {
        SoakRound round;
        for (const std::string& preset : presets)
            burn(preset, renderer, round);
        round.tick_ms /= count, round.picture_ms /= count;
        round.gl_objects = gl_objects();
        round.megabytes = resident_megabytes();
        round.minutes = milliseconds_since(begin) / 60e3;
        rounds.push_back(round);
    } while (rounds.size() < most_rounds && rounds.back().minutes < minutes);
    std::printf("%s", soak_table(rounds).c_str());
    return judge(rounds).faults.empty() ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
    double minutes = 60;
    std::size_t rounds = 1'000'000;
    std::vector<std::string> presets;
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (more && std::strcmp(argv[i], "--minutes") == 0) {
            minutes = std::stod(argv[++i]);
        } else if (more && std::strcmp(argv[i], "--rounds") == 0) {
            rounds = std::stoul(argv[++i]);
        } else {
            presets.emplace_back(argv[i]);
        }
    }
    if (presets.empty()) presets = {"paper/corner", "paper/stack", "real/office", "scenes/leaf"};
    try {
        return soak(minutes, rounds, presets);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
        return 1;
    }
}
