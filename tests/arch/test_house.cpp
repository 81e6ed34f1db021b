// The rules of the house, read from the sources themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace {

const std::filesystem::path kRoot = EMBERLEAF_SOURCE;

struct SourceFile {
    std::string name;  // relative to the root
    std::vector<std::string> lines;
};

bool has_extension(const std::filesystem::path& path, const std::vector<std::string>& extensions) {
    return std::find(extensions.begin(), extensions.end(), path.extension().string()) !=
           extensions.end();
}

SourceFile read(const std::filesystem::path& path) {
    SourceFile file{path.lexically_relative(kRoot).generic_string(), {}};
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);)
        file.lines.push_back(line);
    return file;
}

std::vector<SourceFile> files_below(const std::vector<std::string>& folders,
                                    const std::vector<std::string>& extensions) {
    std::vector<SourceFile> files;
    for (const std::string& folder : folders) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / folder)) {
            if (entry.is_regular_file() && has_extension(entry.path(), extensions)) {
                files.push_back(read(entry.path()));
            }
        }
    }
    return files;
}

std::vector<SourceFile> code_below(const std::vector<std::string>& folders) {
    return files_below(folders, {".h", ".cpp"});
}

// Fails for every include below `folders` that matches `forbidden`, unless it matches `allowed`.
void expect_no_include(const std::vector<std::string>& folders, const std::string& forbidden,
                       const std::string& allowed = "^$") {
    static const std::regex include("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"].*");
    const std::regex bad(forbidden), good(allowed);
    std::size_t seen = 0;
    for (const SourceFile& file : code_below(folders)) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (!std::regex_match(file.lines[i], match, include)) continue;
            ++seen;
            const std::string name = match[1];
            EXPECT_FALSE(std::regex_search(name, bad) && !std::regex_search(name, good))
                << file.name << ':' << i + 1 << " may not include " << name;
        }
    }
    EXPECT_GT(seen, 10u) << "the scan has found the sources";
}

TEST(Dependencies, TheSimulationKnowsOnlyEigenAndTheStandardLibraryWithoutFilesAndClocks) {
    expect_no_include({"sim"}, "/", "^(sim|Eigen)/");
    expect_no_include({"sim"}, "^(filesystem|fstream|iostream|chrono|ctime|random|cstdio|.*\\.h)$",
                      "^(sim/.*|cstdio|immintrin\\.h)$");
}

TEST(Dependencies, RunOneWay) {
    expect_no_include({"app/preset_io"}, "^(app|render|ui)/", "^app/preset_io/");
    expect_no_include({"render"}, "^(app|ui)/", "^app/preset_io/");
    expect_no_include({"ui"}, "^app/", "^app/preset_io/");
}

TEST(Dependencies, TheRendererSeesViewsNeverTheWorld) {
    expect_no_include({"render"}, "^sim/(world|world_state|tick|workspace|lattice)\\.h$");
}

TEST(Dependencies, EveryLibraryIsKnownInOnePlace) {
    expect_no_include({"sim", "render", "app"}, "^(GLFW|imgui)");
    expect_no_include({"sim", "render", "ui"}, "^(CLI|nlohmann|toml\\+\\+)/");
    expect_no_include({"sim", "app"}, "^(glad|EGL|GL)/");
    for (const SourceFile& file : code_below({"sim", "render", "ui", "app"})) {
        for (const std::string& line : file.lines) {
            const bool osmesa = line.find("#include") == 0 && line.find("osmesa") < line.size();
            EXPECT_FALSE(osmesa && file.name != "render/offscreen_context.cpp") << file.name;
        }
    }
}

TEST(Sizes, FilesStayShort) {
    for (const SourceFile& file : code_below({"sim", "render", "ui", "app", "textures"}))
        EXPECT_LE(file.lines.size(), 300u) << file.name;
    for (const SourceFile& file : code_below({"tests"}))
        EXPECT_LE(file.lines.size(), 350u) << file.name;
    for (const SourceFile& file : files_below({"shaders"}, {".glsl", ".vert", ".frag"}))
        EXPECT_LE(file.lines.size(), 300u) << file.name;
}

std::size_t indentation(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first == std::string::npos ? std::string::npos : first;
}

// Length of the block that the closing brace on `last` ends: up to the line that is indented no
// more than the brace. The formatter indents functions by 0, and by 4 inside a class.
std::size_t block_length(const SourceFile& file, std::size_t last) {
    const std::size_t depth = indentation(file.lines[last]);
    std::size_t first = last;
    while (first > 0) {
        const std::string& line = file.lines[--first];
        const std::size_t indent = indentation(line);
        if (indent != std::string::npos && indent <= depth && line[0] != '#') break;
    }
    return last - first + 1;
}

TEST(Sizes, FunctionsStayShort) {
    std::size_t seen = 0;
    for (const SourceFile& file : code_below({"sim", "render", "ui", "app", "tests", "textures"})) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (file.lines[i] != "}" && file.lines[i] != "    }") continue;
            ++seen;
            EXPECT_LE(block_length(file, i), 60u)
                << file.name << ':' << i + 1 << " ends a function of " << block_length(file, i)
                << " lines";
        }
    }
    EXPECT_GT(seen, 200u);
}

TEST(Sizes, TheScanMeasuresAFunction) {
    const SourceFile file{"",
                          {"#pragma once", "int f(int a,", "      int b) {", "    if (a) {",
                           "        return b;", "    }", "    return a;", "}"}};
    EXPECT_EQ(block_length(file, 7), 7u);
    EXPECT_EQ(block_length(file, 5), 3u);
}

// Where a shader, with `common` before it, asks for differences between neighbouring pixels, itself
// or through a function, after it may have discarded a pixel: lines of `shader`, from 0.
std::vector<std::size_t> differences_after_discard(const SourceFile& common,
                                                   const SourceFile& shader) {
    std::string asks = "dFdx|dFdy|fwidth|texture";
    static const std::regex function("^[a-z]\\w* (\\w+)\\(.*");
    std::vector<std::size_t> found;
    std::string name;
    bool discarded = false;
    const auto scan = [&](const SourceFile& file, bool report) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string line = file.lines[i].substr(0, file.lines[i].find("//"));
            std::smatch match;
            if (std::regex_match(line, match, function)) name = match[1];
            if (!name.empty() && std::regex_search(line, std::regex("\\b(" + asks + ")\\("))) {
                if (name != "main") asks += '|' + name;
                if (discarded && report) found.push_back(i);
            }
            discarded |= line.find("discard;") < line.size();
        }
    };
    scan(common, false);
    scan(shader, true);
    return found;
}

TEST(Shaders, ADiscardComesAfterAllDifferencesBetweenPixels) {
    const SourceFile common = read(kRoot / "shaders/common.glsl");
    std::size_t discards = 0;
    for (const SourceFile& file : files_below({"shaders"}, {".frag"})) {
        for (const std::string& line : file.lines)
            discards += line.find("discard;") < line.size();
        for (const std::size_t i : differences_after_discard(common, file))
            ADD_FAILURE() << file.name << ':' << i + 1
                          << " has undefined derivatives, NaN on some graphics cards";
    }
    EXPECT_GT(discards, 1u) << "the scan has found the discards";
}

TEST(Shaders, TheScanSeesThroughFunctions) {
    const SourceFile common{"", {"vec3 f(vec2 p) {", "    return texture(u_map, p).rgb;", "}"}};
    const SourceFile shader{"",
                            {"void main() {", "    float wide = fwidth(x);", "    vec3 a = f(uv);",
                             "    if (wide > 1.0) discard;", "    // fwidth(x)",
                             "    vec3 b = f(uv);", "    float c = dFdx(x);", "}"}};
    EXPECT_EQ(differences_after_discard(common, shader), (std::vector<std::size_t>{5, 6}));
}

TEST(Names, NoPathOfOneMachineIsInTheRepository) {
    const std::regex machine("/(work|home|root|Users)/[A-Za-z]");
    std::vector<SourceFile> files =
        files_below({"sim", "render", "ui", "app", "shaders", "textures", "tests", "presets",
                     "docs", "cmake", ".ci"},
                    {".h", ".cpp", ".txt", ".cmake", ".md", ".toml", ".glsl", ".vert", ".frag",
                     ".in", ".sh", ""});
    for (const char* name : {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CMakeLists.txt",
                             "CMakePresets.json", "run", "test"}) {
        files.push_back(read(kRoot / name));
    }
    for (const SourceFile& file : files) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            EXPECT_FALSE(std::regex_search(file.lines[i], machine))
                << file.name << ':' << i + 1 << ": " << file.lines[i];
        }
    }
}

TEST(Documents, EveryFileTheyNameExists) {
    const std::regex quoted("`([A-Za-z_.]+(/[A-Za-z0-9_.]+)*\\.[a-z]+)`");
    const std::regex ours("^(sim|render|ui|app|shaders|textures|tests|presets|docs|cmake)/");
    std::size_t seen = 0;
    for (const char* name : {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"}) {
        const SourceFile file = read(kRoot / name);
        ASSERT_FALSE(file.lines.empty()) << name;
        for (const std::string& line : file.lines) {
            for (std::sregex_iterator match(line.begin(), line.end(), quoted), end; match != end;
                 ++match) {
                const std::string path = (*match)[1];
                if (!std::regex_search(path, ours)) continue;
                ++seen;
                EXPECT_TRUE(std::filesystem::exists(kRoot / path)) << name << " names " << path;
            }
        }
    }
    EXPECT_GT(seen, 20u);
}

TEST(Documents, TheArchitectureNamesEverySourceOfTheSimulation) {
    std::string text;
    for (const std::string& line : read(kRoot / "ARCHITECTURE.md").lines)
        text += line + '\n';
    for (const SourceFile& file : files_below({"sim"}, {".h"}))
        EXPECT_NE(text.find('`' + file.name + '`'), std::string::npos) << file.name;
}

}  // namespace
