#include "ui/preset_list.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>

#include "ui/document.h"

namespace ember {
namespace {

constexpr const char* kTime = "3";  // [s] in mid-burn
constexpr const char* kSize = "256x144";
constexpr int kNice = 15;

void list_folder(const std::filesystem::path& folder, bool own, std::vector<ListedPreset>& list) {
    std::error_code error;
    const std::size_t first = list.size();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        if (entry.path().extension() != ".toml") continue;
        PresetValues values;
        const PresetResult result = load_preset(entry.path(), values.bindings());
        if (!result.ok()) continue;
        auto name = entry.path().lexically_relative(folder);
        name.replace_extension();
        list.push_back({name.generic_string(), result.info.title, entry.path(), own});
    }
    std::sort(list.begin() + static_cast<std::ptrdiff_t>(first), list.end(),
              [](const ListedPreset& a, const ListedPreset& b) { return a.name < b.name; });
}

// FNV-1a.
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 14695981039346656037ull;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return hash;
}

}  // namespace

std::vector<ListedPreset> list_presets(const std::filesystem::path& folder) {
    std::vector<ListedPreset> list;
    list_folder(folder, true, list);
    for (const std::filesystem::path& built_in : preset_folders()) {
        const std::size_t before = list.size();
        list_folder(built_in, false, list);
        if (list.size() > before) break;
    }
    return list;
}

std::filesystem::path Thumbnails::name_of(const std::filesystem::path& preset) const {
    std::error_code gone;
    const auto time = std::filesystem::last_write_time(preset, gone).time_since_epoch().count();
    char digits[24];
    std::snprintf(digits, sizeof digits, "_%016llx",
                  static_cast<unsigned long long>(
                      hash_of(std::filesystem::absolute(preset).string() + std::to_string(time))));
    return cache_ / "thumbnails" / (preset.stem().string() + digits + ".png");
}

std::filesystem::path Thumbnails::file_of(const std::filesystem::path& preset) const {
    const std::filesystem::path file = name_of(preset);
    return std::filesystem::exists(file) ? file : std::filesystem::path();
}

void Thumbnails::want(const std::vector<ListedPreset>& presets) {
    queue_.clear();
    for (const ListedPreset& preset : presets) {
        if (file_of(preset.path).empty()) queue_.push_back(preset.path);
    }
}

void Thumbnails::poll() {
    if (child_ != nullptr) {
        if (!child_->poll()) return;
        child_.reset();
    }
    if (queue_.empty()) return;
    const std::filesystem::path preset = queue_.front();
    queue_.pop_front();
    try {
        child_ = std::make_unique<ChildProcess>(
            std::vector<std::string>{own_program(), "render", preset, "--at", kTime, "--size",
                                     kSize, "--threads", "1", "-q", "-o", name_of(preset)},
            kNice);
    } catch (const std::exception&) {
        queue_.clear();  // a browser without pictures is still a browser
    }
}

}  // namespace ember
