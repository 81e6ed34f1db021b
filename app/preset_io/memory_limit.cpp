#include "app/preset_io/memory_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "sim/scene_check.h"

namespace ember {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t of_machine() {
    std::ifstream in("/proc/meminfo");
    for (std::string line; std::getline(in, line);) {
        unsigned long long kilobytes = 0;
        if (std::sscanf(line.c_str(), "MemAvailable: %llu kB", &kilobytes) == 1)
            return 1024 * kilobytes;
    }
    return kUnlimited;
}

// Not less what the group has taken: most of that may be files that can be read again.
std::uint64_t of_group() {
    std::uint64_t most = 0;
    std::ifstream in("/sys/fs/cgroup/memory.max");  // "max" without a limit
    return in >> most ? most : kUnlimited;
}

std::uint64_t of_limits() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
    return limit.rlim_cur;
}

std::string gigabytes(std::uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GB", static_cast<double>(bytes) * 1e-9);
    return text;
}

}  // namespace

std::uint64_t free_memory() {
    return std::min({of_machine(), of_group(), of_limits()});
}

void check_memory(const Params& params, std::uint64_t bytes) {
    // measured: by how much a tick of paper/corner takes more on a finer lattice, without drawing
    constexpr std::uint64_t kBytesPerNode = 1100;
    const auto nodes = static_cast<std::uint64_t>(count_nodes(params));
    if (nodes * kBytesPerNode <= bytes) return;
    throw SceneError(params.sheets.empty() ? "sheet.rows" : "sheets",
                     std::to_string(nodes) + " nodes need about " +
                         gigabytes(nodes * kBytesPerNode) + " of memory, and " + gigabytes(bytes) +
                         " are free");
}

}  // namespace ember
