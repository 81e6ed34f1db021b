#include "app/bench/render_bench.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>

#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/run_options.h"
#include "render/renderer.h"

namespace ember {
namespace {

constexpr double kMoment = 4.5;  // [s] mid-burn

struct Format {
    const char* name;
    int width, height;
};
constexpr Format kFormats[] = {
    {"640x360", 640, 360}, {"1280x720", 1280, 720}, {"1920x1080", 1920, 1080}};
constexpr std::pair<Quality, const char*> kQualities[] = {{Quality::Full, "full"},
                                                          {Quality::Preview, "preview"}};

// Of one pass or a whole frame, one entry per frame [ms]: by the clock, and of all processors.
struct Times {
    std::vector<double> wall, processor;
};

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Times by pass in the order in which passes ran, the whole frame last.
class PassClock {
  public:
    void begin() { start_ = last_ = now(); }
    void passed(const std::string& pass) {
        add(pass, last_);
        last_ = now();
    }
    void end() { add("frame", start_); }
    [[nodiscard]] const std::vector<std::string>& order() const { return order_; }
    [[nodiscard]] const Times& times(const std::string& pass) const { return times_.at(pass); }

  private:
    using Moment = std::pair<double, double>;
    static Moment now() { return {wall_seconds(), processor_seconds()}; }
    void add(const std::string& pass, const Moment& since) {
        const Moment at = now();
        if (times_.count(pass) == 0) order_.push_back(pass);
        Times& times = times_[pass];
        times.wall.push_back(1e3 * (at.first - since.first));
        times.processor.push_back(1e3 * (at.second - since.second));
    }
    Moment start_, last_;
    std::vector<std::string> order_;
    std::map<std::string, Times> times_;
};

void measure(Renderer& renderer, const WorldView& view, const RenderParams& params,
             const Format& format, int frames, PassClock& clock) {
    // the first frame allocates
    for (int frame = -1; frame < frames; ++frame) {
        if (frame == 0)
            renderer.observe_passes(
                [&](std::string_view pass) { clock.passed(std::string(pass)); });
        clock.begin();
        static_cast<void>(renderer.draw_image({&view, {}}, params, format.width, format.height));
        if (frame >= 0) clock.end();
    }
    renderer.observe_passes({});
}

}  // namespace

int bench_render(const RenderBenchOptions& options) {
    RunOptions run;
    run.preset = options.preset;
    const LoadedPreset preset = load_run(run);
    World world = build_world(preset, options.common.threads);
    while (world.state().time < kMoment - 1e-9) {
        const StepReport report = world.step();
        if (!report.ok()) throw RunError(divergence_text(report));
    }
    const auto context = OffscreenContext::create(options.gl);
    Renderer renderer(context->loader());
    std::printf("%s at %.1f s, %zu particles, %s\n", options.preset.c_str(), kMoment,
                world.view().particles.x.size(), renderer.description().c_str());
    CsvTable table({"preset", "size", "quality", "pass", "ms", "ms of processor time", "renderer"});
    for (const Format& format : kFormats) {
        for (const auto& [quality, name] : kQualities) {
            RenderParams params = preset.render;
            params.look.quality = quality;
            PassClock clock;
            measure(renderer, world.view(), params, format, options.common.quick ? 3 : 9, clock);
            for (const std::string& pass : clock.order()) {
                const double wall = median(clock.times(pass).wall);
                const double processor = median(clock.times(pass).processor);
                std::printf("%-10s %-8s %-9s %8.2f ms %8.2f ms of processor time\n", format.name,
                            name, pass.c_str(), wall, processor);
                table.add({options.preset, format.name, name, pass, short_text(wall, 5),
                           short_text(processor, 5), renderer.description()});
            }
        }
    }
    write_file(options.common.out / "render.csv", table.text());
    return kOk;
}

}  // namespace ember
