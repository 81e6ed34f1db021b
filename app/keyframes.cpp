#include "app/keyframes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/exit_code.h"
#include "app/preset_io/parameter_value.h"
#include "app/preset_io/preset_io.h"
#include "sim/param_table.h"

namespace ember {
namespace {

// Slopes at the keys that leave no overshoot: F. N. Fritsch and J. Butland, "A method for
// constructing local monotone piecewise cubic interpolants", 1984: the weighted harmonic mean of
// the slopes on both sides, 0 where they have different signs and at the ends.
std::vector<double> monotone_slopes(const std::vector<double>& t, const std::vector<double>& v) {
    std::vector<double> slopes(t.size(), 0.0);
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
        const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
        const double left = (v[i] - v[i - 1]) / before, right = (v[i + 1] - v[i]) / after;
        if (left * right <= 0) continue;
        const double w = (before + 2 * after) / (3 * (before + after));
        slopes[i] = left * right / (w * right + (1 - w) * left);
    }
    return slopes;
}

[[noreturn]] void refuse(const std::string& key, const std::string& reason) {
    throw InputError("--animate: error: " + key + ": " + reason);
}

// "TIME:VALUE,TIME:VALUE"
void read_keys(const ParamInfo& row, const std::string& text, std::vector<double>& times,
               std::vector<double>& values) {
    const std::string key(row.key);
    Params params;
    RenderParams render;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');) {
        const std::size_t colon = part.find(':');
        double time = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), time);
        if (colon == std::string::npos || error != std::errc() || end != part.data() + colon ||
            !std::isfinite(time)) {
            refuse(key, "expected TIME:VALUE,TIME:VALUE, in seconds, got \"" + part + '"');
        }
        if (!times.empty() && time <= times.back()) refuse(key, "times must ascend");
        const ParamBinding bindings[] = {bind(params), bind(render)};
        for (const Diagnostic& problem :
             apply_override(key + '=' + part.substr(colon + 1), bindings, "--animate")) {
            if (problem.severity == Diagnostic::Severity::Error) throw InputError(problem.text());
        }
        const bool drawn = find_param(render_param_rows(), key) != nullptr;
        times.push_back(time);
        values.push_back(row.get(drawn ? bindings[1].object : bindings[0].object));
    }
    if (times.empty()) refuse(key, "expected TIME:VALUE,TIME:VALUE");
}

}  // namespace

Track::Track(const ParamInfo& row, std::vector<double> times, std::vector<double> values)
    : row_(&row), times_(std::move(times)), values_(std::move(values)) {
    smooth_ = row.kind == ParamKind::Real;
    logarithmic_ = smooth_ && row.scale == ParamScale::Logarithmic &&
                   *std::min_element(values_.begin(), values_.end()) > 0;
    if (logarithmic_) {
        for (double& value : values_)
            value = std::log(value);
    }
    slopes_ = monotone_slopes(times_, values_);
}

double Track::at(double time) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    const auto n = static_cast<std::size_t>(after - times_.begin());
    double value = values_[n == 0 ? 0 : n - 1];
    if (smooth_ && n > 0 && n < times_.size()) {
        const double length = times_[n] - times_[n - 1], s = (time - times_[n - 1]) / length;
        value = (1 + 2 * s) * (1 - s) * (1 - s) * values_[n - 1] +
                s * s * (3 - 2 * s) * values_[n] +
                length * s * (1 - s) * ((1 - s) * slopes_[n - 1] - s * slopes_[n]);
    }
    return logarithmic_ ? std::exp(value) : value;
}

void Keyframes::add(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0, equals);
    if (equals == std::string::npos) refuse(text, "expected KEY=TIME:VALUE,TIME:VALUE");
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    const ParamInfo* drawn = find_param(render_param_rows(), key);
    const ParamInfo* row = drawn != nullptr ? drawn : find_param(sim_param_rows(), key);
    if (row == nullptr) {
        const std::string near = nearest_key(key, bindings);
        refuse(key, "unknown key" + (near.empty() ? "" : "; did you mean " + near + '?'));
    }
    if (!row->is_number()) refuse(key, "only numbers, toggles and choices can change");
    if (row->group() == "shot" || row->applies == ParamApplies::Rebuild)
        refuse(key, "cannot change during a run");
    std::vector<double> times, values;
    read_keys(*row, text.substr(equals + 1), times, values);
    (drawn != nullptr ? render_ : sim_).emplace_back(*row, std::move(times), std::move(values));
    texts_.push_back(text);
}

void Keyframes::apply(Params& params, double time) const {
    for (const Track& track : sim_)
        track.row().set(&params, track.at(time));
}

void Keyframes::apply(World& world) const {
    Params params = world.params();
    apply(params, world.state().time);
    if (compare(params, world.params()) == ParamChange::None) return;
    static_cast<void>(world.apply(params));  // add() has taken live parameters only
}

void Keyframes::apply(RenderParams& params, double time) const {
    for (const Track& track : render_)
        track.row().set(&params, track.at(time));
}

}  // namespace ember
