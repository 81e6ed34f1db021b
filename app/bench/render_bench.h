// emberleaf bench render.
#pragma once

#include <string>

#include "app/bench/bench_run.h"
#include "render/offscreen_context.h"

namespace ember {

struct RenderBenchOptions {
    BenchOptions common;
    std::string preset = "paper/corner";
    GlBackend gl = GlBackend::Auto;
};

/// Milliseconds per pass of a picture in mid-burn, for three sizes and both qualities. Every pass
/// waits for its end, so that the sum is a little more than a frame takes otherwise.
int bench_render(const RenderBenchOptions& options);

}  // namespace ember
