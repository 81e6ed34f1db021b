#include "ui/recovery.h"

#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "app/preset_io/atomic_file.h"

namespace ember {
namespace {

constexpr const char* kPrefix = "running_";

bool runs(const std::string& process) {
    const long number = std::strtol(process.c_str(), nullptr, 10);
    return number > 0 && (::kill(static_cast<pid_t>(number), 0) == 0 || errno == EPERM);
}

}  // namespace

Recovery::Recovery(std::filesystem::path folder)
    : folder_(std::move(folder)),
      file_(folder_ / (kPrefix + std::to_string(::getpid()) + ".take")) {}

std::vector<std::filesystem::path> Recovery::left_behind() const {
    std::vector<std::filesystem::path> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, none)) {
        const std::string name = entry.path().stem().string();
        if (!name.starts_with(kPrefix) || entry.path().extension() != ".take") continue;
        const std::string process = name.substr(std::string(kPrefix).size());
        if (runs(process)) continue;
        const std::filesystem::path kept = folder_ / ("recovered_" + process + ".take");
        std::filesystem::rename(entry.path(), kept, none);
        if (!none) found.push_back(kept);
    }
    return found;
}

void Recovery::keep(const std::string& take, double now) {
    kept_ = now;
    if (take == text_) return;
    write_file(file_, take);
    text_ = take;
}

void Recovery::forget() {
    if (text_.empty()) return;
    std::error_code gone;
    std::filesystem::remove(file_, gone);
    text_.clear();
}

}  // namespace ember
