// Lighters: which there are, where they are and when they burn.
#pragma once

#include <vector>

#include "sim/params.h"
#include "sim/types.h"
#include "sim/world_view.h"

namespace ember {

/// All lighters of a scene: [lighter] with what each element of Params::lighters says
/// differently, or [lighter] alone. Never empty.
[[nodiscard]] std::vector<LighterParams> lighters_of(const Params& params);

/// Makes lighter `number` what `lighter` says.
void set_lighter(Params& params, std::size_t number, const LighterParams& lighter);

/// Whether the lighter burns at some moment of [time, time + dt).
[[nodiscard]] bool lighter_lit(const LighterParams& lighter, double time, double dt);

/// Where it is at `time` [m]: on its path, linear between keyframes and at rest beyond them, or at
/// its place. A function of time alone, so that ticks and sub-steps agree.
[[nodiscard]] Vector3 lighter_position(const LighterParams& lighter, double time);

/// What others see of lighters in [time, time + dt).
[[nodiscard]] std::vector<LighterView> view_lighters(const std::vector<LighterParams>& lighters,
                                                     double time, double dt);

}  // namespace ember
