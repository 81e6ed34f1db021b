// emberleaf export: the moving geometry of a shot, for other programs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/frame_painter.h"
#include "app/frame_source.h"
#include "app/interrupt.h"
#include "app/mesh_files.h"
#include "app/preset_io/atomic_file.h"
#include "app/usda_file.h"
#include "app/version.h"

namespace ember {
namespace {

struct ExportOptions {
    RenderOptions shot;
    std::string topology = "constant";
    bool particles = true;
};

enum class MeshKind { Usda, Ply, Obj, PointCache };

MeshKind mesh_kind(const ExportOptions& options) {
    const std::string& output = options.shot.outputs.front();
    const std::string extension = std::filesystem::path(output).extension().string();
    const auto refuse = [&output](const std::string& reason) {
        throw InputError("-o " + output + ": error: " + reason);
    };
    const bool constant = options.topology == "constant";
    if (extension == ".usda") return MeshKind::Usda;
    if (extension == ".pc2" && !constant)
        refuse("a point cache has one topology; leave out --topology varying");
    if (extension == ".pc2") return MeshKind::PointCache;
    if (extension != ".ply" && extension != ".obj")
        refuse("expected a name that ends in .usda, .ply, .obj or .pc2");
    static_cast<void>(FilePattern(output));
    return extension == ".ply" ? MeshKind::Ply : MeshKind::Obj;
}

// Simulates and keeps all frames; fewer when it diverges or is interrupted.
std::vector<KeptFrame> keep_frames(const ExportOptions& options, const RenderJob& job, World& world,
                                   const std::vector<PlannedPicture>& pictures,
                                   StepReport& last_report) {
    FrameSource source(world, nullptr, [&](const StepReport& report) { last_report = report; });
    if (job.keys.move_simulation()) {
        source.before_each_tick([&job](World& moved) { job.keys.apply(moved); });
    }
    Progress progress("frames", static_cast<long>(pictures.size()),
                      Progress::style_of(options.shot.progress, options.shot.run.quiet));
    std::vector<KeptFrame> frames;
    FrameView frame;
    for (const PlannedPicture& picture : pictures) {
        if (interrupt_signal() != 0 || !source.show(picture.time, frame)) break;
        frames.push_back(keep_frame(frame.view));
        progress.update(static_cast<long>(frames.size()));
    }
    progress.finish();
    return frames;
}

void write_scene(const ExportOptions& options, const RenderJob& job,
                 const std::vector<PlannedPicture>& pictures, std::vector<KeptFrame> frames) {
    const std::filesystem::path path = options.shot.outputs.front();
    UsdaScene scene;
    scene.comment = std::string("emberleaf ") + kVersion + ", " + options.shot.run.preset;
    scene.fps = job.preset.render.shot.fps;
    scene.particles = options.particles;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        scene.numbers.push_back(pictures[f].number);
        const RenderParams look = look_at(job, options.shot.turntable, pictures[f].clock);
        scene.cameras.push_back({look.camera, job.size.width, job.size.height});
    }
    scene.frames = std::move(frames);
    make_folder_of(path);
    const std::filesystem::path temporary = temporary_name(path);
    std::ofstream out(temporary, std::ios::binary);
    write_usda(out, scene);
    out.close();
    if (!out) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw RunError(path.string() + ": cannot write: " + std::strerror(errno));
    }
    publish_file(temporary, path);
}

void write_meshes(const ExportOptions& options, MeshKind kind,
                  const std::vector<PlannedPicture>& pictures,
                  const std::vector<KeptFrame>& frames) {
    const std::filesystem::path path = options.shot.outputs.front();
    std::vector<MeshFrame> meshes;
    for (const KeptFrame& frame : frames)
        meshes.push_back(joined(frame.sheets));
    if (kind == MeshKind::PointCache) {
        std::filesystem::path base = path;
        write_file(base.replace_extension(".obj"), mesh_obj(meshes.front()));
        write_file(path, point_cache(meshes, static_cast<float>(pictures.front().number)));
        return;
    }
    const FilePattern pattern(path.string(), frames.size() > 1);
    for (std::size_t f = 0; f < meshes.size(); ++f) {
        write_file(pattern.name(pictures[f].number),
                   kind == MeshKind::Ply ? mesh_ply(meshes[f]) : mesh_obj(meshes[f]));
    }
}

int run_export(const ExportOptions& options) {
    const MeshKind kind = mesh_kind(options);
    const RenderJob job = load_render_job(options.shot);
    const std::vector<PlannedPicture> pictures =
        plan_pictures(options.shot, job.preset.render.shot);
    World world = start_world(options.shot, job, pictures.front().time);
    watch_for_interrupts();
    StepReport last_report;
    std::vector<KeptFrame> frames = keep_frames(options, job, world, pictures, last_report);
    if (!last_report.ok() && frames.empty()) throw RunError(divergence_text(last_report));
    if (frames.empty()) return 128 + interrupt_signal();
    for (std::size_t s = 0; s < world.state().sheets.size() && options.topology == "constant";
         ++s) {
        const MeshFrame last = frames.back().sheets[s];
        for (KeptFrame& frame : frames)
            frame.sheets[s] = with_vertices_of(last, frame.sheets[s]);
    }
    const std::size_t count = frames.size();
    if (kind == MeshKind::Usda) {
        write_scene(options, job, pictures, std::move(frames));
    } else {
        write_meshes(options, kind, pictures, frames);
    }
    if (!options.shot.run.quiet) {
        std::fprintf(stderr, "%s: %zu frames\n", options.shot.outputs.front().c_str(), count);
    }
    if (!last_report.ok()) throw RunError(divergence_text(last_report));
    return interrupt_signal() == 0 ? kOk : 128 + interrupt_signal();
}

}  // namespace

void add_export_command(CLI::App& command, Task& task) {
    const auto options = std::make_shared<ExportOptions>();
    add_run_options(command, options->shot.run);
    command
        .add_option("-o,--output", options->shot.outputs,
                    "burn.usda; burn_####.ply or .obj; burn.pc2 with burn.obj")
        ->required()
        ->allow_extra_args(false)
        ->expected(1)
        ->type_name("FILE");
    command
        .add_option("--topology", options->topology,
                    "constant: one mesh for all frames, whose cracks are closed before they open")
        ->check(CLI::IsMember({"constant", "varying"}))
        ->type_name("constant|varying")
        ->capture_default_str();
    command.add_flag("!--no-particles", options->particles, "leave out the fire in .usda");
    command.add_option("--progress", options->shot.progress, "on stderr")
        ->check(CLI::IsMember({"auto", "json", "none"}))
        ->type_name("auto|json|none");
    add_time_options(command, options->shot);
    add_view_options(command, options->shot);
    add_turntable_option(command, options->shot);
    command.callback([options, &task] { task = [options] { return run_export(*options); }; });
}

}  // namespace ember
