#include "app/bench/bench_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <mutex>
#include <numeric>
#include <thread>

#include "app/exit_code.h"
#include "app/run_options.h"
#include "app/version.h"
#include "sim/param_table.h"

namespace ember {

Params bench_params(const std::string& preset, const std::vector<std::string>& sets) {
    RunOptions options;
    options.preset = preset;
    options.sets = sets;
    return load_run(options).params;
}

void set_params(Params& params, const std::vector<std::string>& sets) {
    const ParamBinding bindings[] = {bind(params)};
    for (const std::string& text : sets) {
        for (const Diagnostic& d : apply_override(text, bindings)) {
            if (d.severity == Diagnostic::Severity::Error) throw InputError(d.text());
        }
    }
}

void run_jobs(std::size_t count, int threads, const std::function<void(std::size_t)>& job) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr problem;
    std::mutex guard;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                job(i);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (!problem) problem = std::current_exception();
            }
        }
    };
    std::vector<std::thread> team;
    for (int t = 1; t < threads; ++t)
        team.emplace_back(work);
    work();
    for (std::thread& member : team)
        member.join();
    if (problem) std::rethrow_exception(problem);
}

double thread_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

double median(std::vector<double> values) {
    for (const double v : values) {
        if (std::isnan(v)) return v;
    }
    const std::size_t half = values.size() / 2;
    std::sort(values.begin(), values.end());
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double root_mean_square(std::span<const double> values) {
    double sum = 0;
    for (const double v : values)
        sum += v * v;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

double deviation(std::span<const double> values) {
    if (values.size() < 2) return 0;
    const double centre = mean(values);
    double sum = 0;
    for (const double v : values)
        sum += (v - centre) * (v - centre);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::string machine_text() {
    std::string model = "unknown processor";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (!line.starts_with("model name")) continue;
        model = line.substr(line.find(':') + 2);
        break;
    }
    return model + ", " + std::to_string(std::thread::hardware_concurrency()) +
           " threads; compiled by GCC " + __VERSION__ + "; emberleaf " + kVersion;
}

std::string short_text(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

void CsvTable::add(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string& cell = cells[i];
        if (i > 0) text_ += ',';
        if (cell.find_first_of(",\"\n") == std::string::npos) {
            text_ += cell;
            continue;
        }
        text_ += '"';
        for (const char c : cell)
            text_ += c == '"' ? "\"\"" : std::string(1, c);
        text_ += '"';
    }
    text_ += '\n';
}

}  // namespace ember
