#include "golden/approvals.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/preset_io/atomic_file.h"
#include "app/stats_json.h"

namespace ember::golden {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

std::uint64_t read_hash(const Json& value) {
    return std::stoull(value.get<std::string>(), nullptr, 16);
}

Json json_of(const Golden& golden) {
    Json out = {{"parameters", hash_text(golden.parameters)}, {"state", hash_text(golden.state)}};
    for (const Approval& a : golden.approved) {
        out["approved"].push_back({{"pixels", hash_text(a.pixels)},
                                   {"renderer", a.environment.renderer},
                                   {"cpu_caps", a.environment.cpu_caps},
                                   {"reason", a.reason},
                                   {"commit", a.commit}});
    }
    out["work"] = Json::object();
    for (const auto& [name, count] : golden.work)
        out["work"][name] = count;
    return out;
}

Golden golden_of(const Json& json) {
    Golden golden;
    golden.parameters = read_hash(json.at("parameters"));
    golden.state = read_hash(json.at("state"));
    for (const Json& a : json.at("approved")) {
        golden.approved.push_back({read_hash(a.at("pixels")),
                                   {a.at("renderer"), a.at("cpu_caps")},
                                   a.at("reason"),
                                   a.at("commit")});
    }
    for (const auto& [name, count] : json.at("work").items())
        golden.work.emplace_back(name, count.get<std::int64_t>());
    return golden;
}

std::string contents(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

Goldens ApprovedFolder::read(const std::string& suite) const {
    const std::filesystem::path file = folder_ / (suite + ".json");
    Goldens goldens;
    if (!std::filesystem::exists(file)) return goldens;
    try {
        const Json json = Json::parse(contents(file));
        if (json.at("schema") != kSchema) throw std::runtime_error("of another version");
        for (const auto& [name, golden] : json.at("scenes").items())
            goldens[name] = golden_of(golden);
    } catch (const std::exception& e) {
        throw std::runtime_error(file.string() + ": " + e.what());
    }
    return goldens;
}

void ApprovedFolder::write(const std::string& suite, const Goldens& goldens) const {
    Json json = {{"schema", kSchema}, {"scenes", Json::object()}};
    for (const auto& [name, golden] : goldens)
        json["scenes"][name] = json_of(golden);
    const std::string text = json.dump(1) + '\n';
    const std::filesystem::path file = folder_ / (suite + ".json");
    if (!std::filesystem::exists(file) || contents(file) != text) write_file(file, text);
}

std::optional<Image> ApprovedFolder::picture(const std::string& full_name) const {
    const std::filesystem::path file = folder_ / (full_name + ".png");
    if (!std::filesystem::exists(file)) return std::nullopt;
    return read_image(file);
}

void ApprovedFolder::write_picture(const std::string& full_name, const Image& image) const {
    write_png(folder_ / (full_name + ".png"), image);
}

void ApprovedFolder::remove_picture(const std::string& full_name) const {
    std::filesystem::remove(folder_ / (full_name + ".png"));
}

}  // namespace ember::golden
