#include "golden/scene_table.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ember::golden {
namespace {

constexpr int kWidest = 480, kHighest = 270;  // [pixels]; what a repository can afford

// "paper_corner.300_lattice  paper/corner  300  240x135  view.mode=lattice"
Scene read_row(const std::string& line) {
    std::istringstream words(line);
    Scene scene;
    std::string name, size;
    if (!(words >> name >> scene.preset >> scene.tick >> size))
        throw std::runtime_error("expected SUITE.NAME PRESET TICK SIZE [WORDS]");
    const auto known = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    const std::size_t dot = name.find('.');
    scene.suite = name.substr(0, dot);
    scene.name = dot == std::string::npos ? "" : name.substr(dot + 1);
    // other characters mean something in a filter of tests
    for (const std::string& part : {scene.suite, scene.name}) {
        if (part.empty() || !std::all_of(part.begin(), part.end(), known))
            throw std::runtime_error(name + ": expected SUITE.NAME of letters, digits and _");
    }
    const int read = std::sscanf(size.c_str(), "%dx%d+%d+%d", &scene.width, &scene.height,
                                 &scene.left, &scene.top);
    if (read != (scene.panels() ? 4 : 2))
        throw std::runtime_error(size + ": expected WIDTHxHEIGHT, for panels with +LEFT+TOP");
    if (scene.width < 1 || scene.height < 1 || scene.width > kWidest || scene.height > kHighest)
        throw std::runtime_error(size + ": expected at most 480x270");
    for (std::string word; words >> word;)
        scene.words.push_back(word);
    return scene;
}

void check_order(const std::vector<Scene>& before, const Scene& scene) {
    for (const Scene& other : before) {
        if (other.full_name() == scene.full_name())
            throw std::runtime_error(scene.full_name() + " comes twice");
        if (other.suite != scene.suite || scene.panels()) continue;
        if (other.preset != scene.preset)
            throw std::runtime_error(scene.suite + " has two presets, and burns only one");
        if (other.tick > scene.tick)
            throw std::runtime_error(scene.full_name() + ": expected ticks that ascend");
    }
}

}  // namespace

std::vector<Scene> read_scenes(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    std::vector<Scene> scenes;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.find_first_not_of(' ') == std::string::npos || line[0] == '#') continue;
        try {
            const Scene scene = read_row(line);
            check_order(scenes, scene);
            scenes.push_back(scene);
        } catch (const std::runtime_error& e) {
            throw std::runtime_error(file.string() + ':' + std::to_string(number) + ": " +
                                     e.what());
        }
    }
    return scenes;
}

}  // namespace ember::golden
