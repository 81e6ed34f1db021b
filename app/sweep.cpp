#include "app/sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <thread>

#include "app/bounded_queue.h"
#include "app/contact_sheet.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/preset_io/atomic_file.h"
#include "app/preset_io/parameter_value.h"
#include "app/shot_record.h"
#include "app/stats_json.h"

namespace ember {
namespace {

constexpr const char* kColumns =
    "time_s,outcome,unburnt,burning,burnt_out,burnt_10_s,burnt_50_s,burnt_90_s,mass_kg,hottest_C,"
    "cuts,ticks,state_hash";

std::string field(double value) {
    return std::isfinite(value) ? number_text(value) : "";
}

// The figures of one case, as kColumns has them.
std::string figures(const World& world, const StatsRecorder& stats, const StepReport& report) {
    const PhaseCounts nodes = count_phases(world.state());
    double mass = 0, hottest = -INFINITY;
    for (const SheetState& sheet : world.state().sheets) {
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            mass += sheet.mass[n];
            if (sheet.initial_mass[n] > 0)
                hottest = std::max(hottest, sheet.temperature[n] - 273.15);
        }
    }
    std::string text = field(world.state().time) + (report.ok() ? ",ok" : ",stopped");
    for (const std::int64_t count : {nodes.unburnt, nodes.burning, nodes.burnt_out})
        text += ',' + std::to_string(count);
    for (const double share : {0.1, 0.5, 0.9})
        text += ',' + field(stats.burnt_out_time(share));
    return text + ',' + field(mass) + ',' + field(std::round(hottest * 10) / 10) + ',' +
           std::to_string(world.state().totals.cuts) + ',' + std::to_string(world.state().tick) +
           ',' + hash_text(world.hash());
}

std::string label_of(const SweepCase& values) {
    std::string label;
    for (const auto& [key, value] : values)
        label += (label.empty() ? "" : ", ") + key.substr(key.rfind('.') + 1) + ' ' + value;
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

std::filesystem::path with_suffix(const std::string& output, const std::string& suffix) {
    const std::filesystem::path path(output);
    return path.parent_path() / (path.stem().string() + suffix);
}

}  // namespace

// A case that has been simulated.
struct Sweep::Burnt {
    const Case* item = nullptr;
    FrameView frame;
    std::string figures;
};

Sweep::Sweep(const SweepOptions& options, const std::vector<SweepAxis>& axes)
    : options_(options), painter_(options.shot) {
    columns_ = static_cast<int>(axes.back().values.size());
    const std::filesystem::path folder = with_suffix(options.output, "_cases");
    for (const SweepCase& values : sweep_cases(axes)) {
        Case item{values, {}, {}, {}, {}};
        RenderOptions shot = options.shot;
        for (const auto& [key, value] : values)
            shot.run.sets.push_back(key + '=' + value);
        item.job = load_render_job(shot);
        const std::vector<double> times = shot.at.empty()
                                              ? std::vector{item.job.preset.render.shot.duration}
                                              : parse_times(shot.at);
        if (times.size() != 1) throw InputError("--at: error: a sweep takes one time");
        const auto number = static_cast<long>(cases_.size()) + 1;
        item.picture = {number, times[0], 0, 0};
        item.text = shot_text(shot, item.job, painter_.description());
        item.text.emplace_back("Frame", std::to_string(number));
        item.text.emplace_back("Time", number_text(times[0]) + " s");
        const std::string digits = std::to_string(number);
        item.file =
            folder / ("case_" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') +
                      digits + ".png");
        cases_.push_back(std::move(item));
    }
    make_folder_of(cases_.front().file);
    remove_stale_temporaries(folder);
}

bool Sweep::is_there(const Case& item) const {
    try {
        static_cast<void>(read_image(item.file));
        const ImageText text = read_png_text(item.file);
        for (const char* keyword : {"Hash", "Time", "Figures"}) {
            const std::string *is = find_text(text, keyword),
                              *should = find_text(item.text, keyword);
            if (is == nullptr || (should != nullptr && *is != *should)) return false;
        }
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

Sweep::Burnt Sweep::burn(const Case& item) const {
    Burnt burnt{&item, {}, {}};
    World world = build_world(item.job.preset, options_.shot.run.threads);
    StatsRecorder stats;
    StepReport last;
    FrameSource source(
        world, nullptr,
        [&](const StepReport& report) {
            last = report;
            if (report.ok()) stats.record(world, report);
        },
        needs_springs(item.job.preset.render.view.mode));
    bool good = true;
    while (good && interrupt_signal() == 0 &&
           world.state().time + world.tick_duration() < item.picture.time)
        good = source.advance_to(world.state().time + world.tick_duration());
    // a run that was stopped shows how far it came
    good = good && source.show(item.picture.time, burnt.frame);
    if (!good) static_cast<void>(source.show(world.state().time, burnt.frame));
    source.detach(burnt.frame);
    burnt.figures = figures(world, stats, last);
    return burnt;
}

void Sweep::draw(const Burnt& burnt) {
    const Case& item = *burnt.item;
    const Picture picture =
        painter_.paint(item.job, item.picture, std::span(&burnt.frame, 1), true, false);
    ImageText text = item.text;
    text.emplace_back("Figures", burnt.figures);
    write_png(item.file, picture.image, text);
}

void Sweep::run() {
    std::vector<const Case*> missing;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
        if (options_.share.has(static_cast<long>(i)) && !is_there(cases_[i]))
            missing.push_back(&cases_[i]);
    }
    Progress progress("cases", static_cast<long>(missing.size()),
                      Progress::style_of(options_.shot.progress, options_.shot.run.quiet));
    BoundedQueue<Burnt> finished(static_cast<std::size_t>(options_.jobs));
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr error;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < missing.size() && interrupt_signal() == 0; i = next++)
                finished.push(burn(*missing[i]));
        } catch (...) {
            const std::lock_guard lock(mutex);
            error = std::current_exception();
            finished.close();
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < options_.jobs; ++i)
        threads.emplace_back(work);
    std::thread closing([&] {
        for (std::thread& thread : threads)
            thread.join();
        finished.close();
    });
    long done = 0;
    try {
        while (const std::optional<Burnt> burnt = finished.pop()) {
            if (interrupt_signal() != 0) continue;
            draw(*burnt);
            progress.update(++done);
        }
    } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
        next = missing.size();
        finished.close();
    }
    closing.join();
    progress.finish();
    if (error != nullptr) std::rethrow_exception(error);
}

std::string Sweep::assemble() {
    std::vector<LabelledPicture> pictures;
    std::string table = "case,picture";
    for (const auto& [key, value] : cases_.front().values)
        table += ',' + key;
    table += std::string(",") + kColumns + '\n';
    for (const Case& item : cases_) {
        if (!is_there(item)) continue;
        pictures.push_back({read_image(item.file), label_of(item.values)});
        table += std::to_string(item.picture.number) + ',' +
                 std::filesystem::path(item.file).filename().string();
        for (const auto& [key, value] : item.values)
            table += ',' + value;
        table += ',' + *find_text(read_png_text(item.file), "Figures") + '\n';
    }
    if (pictures.size() < cases_.size()) {
        return std::to_string(pictures.size()) + " of " + std::to_string(cases_.size()) +
               " cases are there; the share that completes them makes the sheet";
    }
    const std::filesystem::path csv = with_suffix(options_.output, ".csv");
    write_file(csv, table);
    ImageText text = {{"Software", "emberleaf"}};
    write_png(options_.output, contact_sheet(pictures, columns_), text);
    return options_.output + " and " + csv.string() + ": " + std::to_string(cases_.size()) +
           " cases";
}

}  // namespace ember
