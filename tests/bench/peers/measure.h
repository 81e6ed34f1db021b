// Timing: medians of interleaved repeats, since one timing on a shared machine says little.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace ember::peers {

/// Wall time of one call [s].
template <class Work>
double seconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Median seconds of each piece of work over `repeats` rounds, in each of which all are done once.
inline std::vector<double> interleaved(const std::vector<std::function<void()>>& works,
                                       int repeats) {
    std::vector<std::vector<double>> times(works.size());
    for (int round = 0; round < repeats; ++round) {
        for (std::size_t i = 0; i < works.size(); ++i)
            times[i].push_back(seconds(works[i]));
    }
    std::vector<double> medians;
    for (const auto& t : times)
        medians.push_back(median(t));
    return medians;
}

}  // namespace ember::peers
