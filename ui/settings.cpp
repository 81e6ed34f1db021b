#include "ui/settings.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/preset_io/atomic_file.h"

namespace ember {
namespace {

constexpr int kLeastSize = 320, kMostSize = 16384;  // [points]

void read_size(const std::string& text, int& size) {
    const int value = std::atoi(text.c_str());
    if (value >= kLeastSize && value <= kMostSize) size = value;
}

void read_line(const std::string& key, const std::string& value, Settings& settings) {
    const auto flag = [&](const char* name, bool& target) {
        if (key == name) target = value == "1";
    };
    if (key == "width") read_size(value, settings.width);
    if (key == "height") read_size(value, settings.height);
    flag("maximised", settings.maximised);
    flag("panel", settings.show_panel);
    flag("info", settings.show_info);
    flag("profiler", settings.show_profiler);
    flag("plots", settings.show_plots);
    if (key == "camera" && value == "blender") settings.scheme = CameraScheme::Blender;
    if (key == "camera" && value == "maya") settings.scheme = CameraScheme::Maya;
    if (key == "recent" && settings.recent.size() < Settings::kMostRecent && !value.empty())
        settings.recent.push_back(value);
}

}  // namespace

void Settings::remember(const std::string& preset) {
    std::erase(recent, preset);
    recent.insert(recent.begin(), preset);
    if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

Settings read_settings(const std::filesystem::path& file) {
    Settings settings;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos) continue;
        read_line(line.substr(0, equals), line.substr(equals + 1), settings);
    }
    return settings;
}

void write_settings(const std::filesystem::path& file, const Settings& settings) {
    constexpr const char* kSchemes[] = {"viewer", "blender", "maya"};
    std::ostringstream out;
    out << "width=" << settings.width << "\nheight=" << settings.height
        << "\nmaximised=" << settings.maximised << "\npanel=" << settings.show_panel
        << "\ninfo=" << settings.show_info << "\nprofiler=" << settings.show_profiler
        << "\nplots=" << settings.show_plots
        << "\ncamera=" << kSchemes[static_cast<int>(settings.scheme)] << '\n';
    for (const std::string& preset : settings.recent)
        out << "recent=" << preset << '\n';
    write_file(file, out.str());
}

}  // namespace ember
