#include "golden/runner.h"

#include <array>
#include <cstdio>

#include "app/preset_io/atomic_file.h"
#include "app/stats_json.h"

namespace ember::golden {
namespace {

std::string output_of(const std::string& command, int& status) {
    std::string text;
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run: " + command);
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
        text.append(part.data(), count);
    status = ::pclose(pipe);
    return text;
}

std::string lines_of(const Work& work) {
    std::string text;
    for (const auto& [name, count] : work)
        text += (text.empty() ? "" : ", ") + name + ' ' + std::to_string(count);
    return text;
}

}  // namespace

// A scene as it is, as it should be, and what follows from that.
struct Runner::Seen {
    Drawn drawn;
    Goldens goldens;  // of the suite
    std::optional<Image> expected;
    Verdict verdict;
};

Runner::Seen Runner::look_at(const Scene& scene) {
    if (suite_ != scene.suite || stage_ == nullptr) {
        stage_.reset();  // its context first: only one may exist
        const auto preset = options_.presets / (scene.preset + ".toml");
        stage_ = scene.panels() ? panel_stage(preset, options_.rasteriser)
                                : picture_stage(preset, options_.rasteriser);
        suite_ = scene.suite;
    }
    Seen seen{
        stage_->draw(scene), approved_.read(scene.suite), approved_.picture(scene.full_name()), {}};
    const auto golden = seen.goldens.find(scene.name);
    seen.verdict =
        judge(scene, seen.drawn, golden == seen.goldens.end() ? nullptr : &golden->second,
              seen.expected ? &*seen.expected : nullptr);
    return seen;
}

void Runner::report(const Scene& scene, const Seen& seen) {
    ReportEntry entry;
    entry.name = scene.full_name();
    entry.verdict = seen.verdict.text;
    for (const std::string& line : seen.verdict.more_work)
        entry.verdict += "\nMORE WORK: " + line;
    entry.expected = seen.expected;
    entry.actual = seen.drawn.image;
    entry.facts = {{"preset", scene.preset},
                   {"tick", std::to_string(scene.tick)},
                   {"state hash", hash_text(seen.drawn.state)},
                   {"environment", seen.drawn.environment.text()},
                   {"work", lines_of(seen.drawn.work)}};
    const auto golden = seen.goldens.find(scene.name);
    if (golden != seen.goldens.end()) {
        entry.facts.emplace_back("recorded state hash", hash_text(golden->second.state));
        for (const Approval& a : golden->second.approved)
            entry.facts.emplace_back("approved", a.environment.text() + ": " + a.reason +
                                                     " (after commit " + a.commit + ')');
    }
    entry.facts.emplace_back("if this is meant",
                             "tests/golden/update \"REASON\" '" + scene.full_name() + '\'');
    failures_.push_back(std::move(entry));
    write_file(options_.report, difference_report("Golden pictures that differ", failures_));
}

Verdict Runner::check(const Scene& scene) {
    const Seen seen = look_at(scene);
    if (!seen.verdict.good()) report(scene, seen);
    return seen.verdict;
}

bool Runner::update(const Scene& scene, const std::string& reason, const std::string& commit) {
    Seen seen = look_at(scene);
    const auto before = seen.goldens.find(scene.name);
    const Golden* golden = before == seen.goldens.end() ? nullptr : &before->second;
    const Golden after = approve(seen.drawn, seen.verdict, golden, reason, commit);
    const bool exact = seen.verdict.outcome == Outcome::Exact && golden != nullptr;
    const bool unchanged = exact && after.work == golden->work &&
                           after.parameters == golden->parameters &&
                           after.approved.size() == golden->approved.size();
    if (unchanged) return false;
    if (!seen.verdict.looks_right()) approved_.write_picture(scene.full_name(), seen.drawn.image);
    seen.goldens[scene.name] = after;
    approved_.write(scene.suite, seen.goldens);
    return true;
}

std::string present_commit(const std::filesystem::path& repository) {
    int status = 0;
    std::string commit =
        output_of("git -C '" + repository.string() + "' rev-parse --short=9 HEAD", status);
    if (status != 0) throw std::runtime_error("git: " + commit);
    while (!commit.empty() && commit.back() == '\n')
        commit.pop_back();
    return commit;
}

std::string update_refusal(const std::filesystem::path& repository,
                           const std::filesystem::path& approved, const char* ci,
                           const std::string& reason) {
    if (ci != nullptr && *ci != '\0' && std::string(ci) != "false" && std::string(ci) != "0")
        return "goldens are not updated in continuous integration (CI is set)";
    if (reason.find_first_not_of(' ') == std::string::npos)
        return "goldens are not updated without a reason";
    int status = 0;
    const std::string changes =
        output_of("git -C '" + repository.string() + "' status --porcelain -- . ':(exclude)" +
                      approved.lexically_relative(repository).generic_string() + '\'',
                  status);
    if (status != 0) return "git does not know what has changed: " + changes;
    if (!changes.empty())
        return "goldens are not updated before everything else is committed:\n" + changes;
    return "";
}

}  // namespace ember::golden
