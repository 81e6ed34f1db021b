#include "app/preset_io/steering.h"

#include <algorithm>
#include <charconv>

#include "app/preset_io/parameter_value.h"
#include "sim/param_table.h"

namespace ember {
namespace {

constexpr std::size_t kMostLighters = 64;

// "lighters=2": how many there are. Returns false when the assignment says something else.
bool set_lighter_count(const std::string& assignment, Params& params) {
    constexpr std::string_view kStart = "lighters=";
    if (!assignment.starts_with(kStart)) return false;
    std::size_t count = 0;
    const char* end = assignment.data() + assignment.size();
    const auto [at, error] = std::from_chars(assignment.data() + kStart.size(), end, count);
    if (error != std::errc() || at != end || count > kMostLighters) return false;
    params.lighters.resize(count);
    return true;
}

void list_changes(const std::string& name, const std::vector<ParamOverrides>& before,
                  const std::vector<ParamOverrides>& after, const Params& shared,
                  std::vector<std::string>& out) {
    if (before.size() != after.size()) out.push_back(name + '=' + std::to_string(after.size()));
    for (std::size_t i = 0; i < after.size(); ++i) {
        const ParamOverrides old = i < before.size() ? before[i] : ParamOverrides{};
        const std::string element = name + '.' + std::to_string(i + 1) + '.';
        for (const ParamOverride& o : after[i]) {
            if (std::ranges::count(old, o) == 0)
                out.push_back(element + std::string(o.row->name()) + '=' +
                              value_text(*o.row, o.value));
        }
        for (const ParamOverride& o : old) {  // what it no longer says it has from its group
            if (std::ranges::count(after[i], o.row, &ParamOverride::row) == 0)
                out.push_back(element + std::string(o.row->name()) + '=' +
                              value_text(*o.row, &shared));
        }
    }
}

}  // namespace

std::vector<std::string> assignments_between(const Params& before, const Params& after) {
    std::vector<std::string> out;
    for (const ParamInfo& row : sim_param_rows()) {
        if (row.value(&before) == row.value(&after)) continue;
        out.push_back(std::string(row.key) + '=' + value_text(row, &after));
    }
    list_changes("lighters", before.lighters, after.lighters, after, out);
    return out;
}

std::vector<PresetEvent> events_of(const Params& base, std::span<const TimedParams> script) {
    std::vector<PresetEvent> events;
    const Params* before = &base;
    for (const TimedParams& entry : script) {
        events.push_back({entry.tick, assignments_between(*before, entry.params), {}});
        before = &entry.params;
    }
    return events;
}

std::vector<TimedParams> script_of(const Params& base, const PresetInfo& info,
                                   std::vector<Diagnostic>& problems) {
    std::vector<PresetEvent> events = info.events;
    std::ranges::stable_sort(events, {}, &PresetEvent::tick);
    std::vector<TimedParams> script;
    Params now = base;
    for (const PresetEvent& event : events) {
        const Params before = now;
        const ParamBinding bindings[] = {bind(now)};
        for (const std::string& assignment : event.set) {
            if (set_lighter_count(assignment, now)) continue;
            for (Diagnostic problem : apply_override(assignment, bindings)) {
                problem.file = event.place.file;
                problem.line = event.place.line;
                problem.column = event.place.column;
                problems.push_back(std::move(problem));
            }
        }
        if (compare(now, before) == ParamChange::Rebuild) {
            problems.push_back({Diagnostic::Severity::Error, event.place.file, event.place.line,
                                event.place.column, "events",
                                "changes a parameter that restarts the scene"});
            now = before;
        }
        if (script.empty() || script.back().tick != event.tick) script.push_back({event.tick, {}});
        script.back().params = now;
    }
    return script;
}

}  // namespace ember
