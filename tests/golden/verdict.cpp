#include "golden/verdict.h"

#include <algorithm>

#include "app/stats_json.h"

namespace ember::golden {
namespace {

constexpr std::size_t kMostApprovals = 3;

// More rows asleep are less work; what the renderer counts depends on the rasteriser.
bool counts_as_work(const std::string& name, bool approved_here) {
    if (name.find("render.") == 0) return approved_here;
    return name != "rows_asleep";
}

std::vector<std::string> more_work(const Work& now, const Work& then, bool approved_here) {
    std::vector<std::string> more;
    for (const auto& [name, count] : now) {
        if (!counts_as_work(name, approved_here)) continue;
        const auto same_name = [&name = name](const auto& entry) { return entry.first == name; };
        const auto recorded = std::find_if(then.begin(), then.end(), same_name);
        const std::int64_t before = recorded == then.end() ? 0 : recorded->second;
        if (count <= before) continue;
        std::string line =
            name + ": " + std::to_string(count) + ", recorded " + std::to_string(before);
        if (before > 0) line += " (+" + std::to_string(100 * (count - before) / before) + " %)";
        more.push_back(line);
    }
    return more;
}

bool approved_in(const Golden& golden, const Environment& environment) {
    return std::any_of(golden.approved.begin(), golden.approved.end(),
                       [&](const Approval& a) { return a.environment == environment; });
}

std::string solver_text(const Scene& scene, const Drawn& drawn, const Golden& golden) {
    std::string text = "SOLVER: the state at tick " + std::to_string(scene.tick) + " has hash " +
                       hash_text(drawn.state) + ", recorded is " + hash_text(golden.state);
    text += drawn.parameters == golden.parameters
                ? ", from the same parameters"
                : ", and the parameters differ from those recorded: look at the preset first";
    return text + "; a picture of another state says nothing about the renderer";
}

std::string renderer_text(const ImageDifference& d, const std::string& why) {
    const std::string levels = std::to_string(d.max_difference);
    if (!why.empty()) return why;
    if (!d.comparable) return "the sizes differ";
    return std::to_string(d.pixels) + " of " + std::to_string(d.total) +
           " pixels differ, by up to " + levels + " levels";
}

}  // namespace

DifferenceLimits close_limits(const Scene& scene) {
    for (const std::string& word : scene.words) {
        for (const char* lines :
             {"view.mode=lattice", "view.mode=stiffness", "view.wireframe=true"})
            if (word == lines) return kCloseLineLimits;
    }
    return kCloseLimits;
}

Verdict judge(const Scene& scene, const Drawn& drawn, const Golden* golden, const Image* expected) {
    Verdict verdict;
    if (expected != nullptr) verdict.difference = compare(*expected, drawn.image);
    if (golden == nullptr || golden->approved.empty() || expected == nullptr) {
        verdict.text = "there is no golden picture";
        return verdict;
    }
    const bool approved_here = approved_in(*golden, drawn.environment);
    verdict.more_work = more_work(drawn.work, golden->work, approved_here);
    if (drawn.state != golden->state) {
        verdict.outcome = Outcome::Solver;
        verdict.text = solver_text(scene, drawn, *golden);
        return verdict;
    }
    const std::uint64_t pixels = hash_of(drawn.image);
    for (const Approval& a : golden->approved) {
        if (a.pixels != pixels) continue;
        verdict.outcome = Outcome::Exact;
        verdict.text = "exact";
        return verdict;
    }
    const std::string why = excess(verdict.difference, close_limits(scene));
    if (!approved_here && why.empty()) {
        verdict.outcome = Outcome::Close;
        verdict.text = "TIER 2 ONLY: close, not exact (" + renderer_text(verdict.difference, "") +
                       "), as nothing is approved for " + drawn.environment.text();
        return verdict;
    }
    verdict.outcome = Outcome::Renderer;
    verdict.text = "RENDERER: the state is as recorded and the picture is not: " +
                   renderer_text(verdict.difference, approved_here ? "" : why);
    return verdict;
}

Golden approve(const Drawn& drawn, const Verdict& verdict, const Golden* golden,
               const std::string& reason, const std::string& commit) {
    Golden result{drawn.parameters, drawn.state, {}, drawn.work};
    const std::uint64_t pixels = hash_of(drawn.image);
    if (golden != nullptr && verdict.looks_right()) result.approved = golden->approved;
    const bool known =
        std::any_of(result.approved.begin(), result.approved.end(), [&](const Approval& a) {
            return a.pixels == pixels && a.environment == drawn.environment;
        });
    if (known) return result;
    if (result.approved.size() == kMostApprovals) result.approved.pop_back();
    result.approved.push_back({pixels, drawn.environment, reason, commit});
    return result;
}

}  // namespace ember::golden
