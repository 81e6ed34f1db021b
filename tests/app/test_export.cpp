// Geometry for other programs, read back by readers of our own.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

#include "app/frame_source.h"
#include "app/geometry_frames.h"
#include "app/mesh_files.h"
#include "app/usda_file.h"
#include "ply_reader.h"
#include "preset_rig.h"
#include "render/camera.h"
#include "usda_reader.h"

namespace ember {
namespace {

// Frames of a small burn that cracks, at 10 frames per second.
std::vector<KeptFrame> burn(int count) {
    Params p;
    p.sheet.rows = 12;
    p.sheet.columns = 18;
    p.sheet.width = 0.0788;
    p.sheet.height = 0.1114;
    p.springs.stiffness_scale = 10;
    p.world.held_gravity = 0.06;
    p.lighter.x = -0.04;
    p.lighter.y = p.sheet.elevation - p.sheet.height - 0.02;
    p.lighter.strength = 1;
    p.burning.burn_speed = 2;
    World world = make_world(p);
    FrameSource source(world, nullptr, {});
    FrameView frame;
    std::vector<KeptFrame> frames;
    for (int f = 0; f < count; ++f) {
        EXPECT_TRUE(source.show(0.1 * f, frame));
        frames.push_back(keep_frame(frame.view));
    }
    return frames;
}

std::vector<KeptFrame> with_last_topology(std::vector<KeptFrame> frames) {
    const MeshFrame last = frames.back().sheets[0];
    for (KeptFrame& frame : frames)
        frame.sheets[0] = with_vertices_of(last, frame.sheets[0]);
    return frames;
}

UsdaScene scene_of(std::vector<KeptFrame> frames) {
    UsdaScene scene;
    scene.comment = "a \"test\"";
    scene.fps = 10;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        scene.numbers.push_back(static_cast<long>(f) + 5);
        scene.cameras.push_back({CameraParams{}, 160, 90});
        scene.cameras.back().params.azimuth = 0.1 * static_cast<double>(f);
    }
    scene.frames = std::move(frames);
    return scene;
}

UsdaStage written(const UsdaScene& scene) {
    std::ostringstream out;
    write_usda(out, scene);
    return read_usda(out.str());
}

TEST(Geometry, TheLastVerticesFollowTheirParentsBeforeTheCut) {
    const std::vector<KeptFrame> frames = burn(30);
    const MeshFrame &first = frames.front().sheets[0], &last = frames.back().sheets[0];
    ASSERT_GT(last.points.size(), first.points.size() + 5) << "it has cracked";
    ASSERT_EQ(last.quads.size(), first.quads.size());
    for (const KeptFrame& frame : frames) {
        const MeshFrame &before = frame.sheets[0], after = with_vertices_of(last, before);
        EXPECT_EQ(after.points.size(), last.points.size());
        EXPECT_EQ(after.quads, last.quads);
        // every corner of every quad is where it was: the shape is the same, whatever is split
        for (std::size_t q = 0; q < after.quads.size(); ++q) {
            for (std::size_t c = 0; c < 4; ++c) {
                const auto a = static_cast<std::size_t>(after.quads[q][c]);
                const auto b = static_cast<std::size_t>(before.quads[q][c]);
                ASSERT_EQ(after.points[a], before.points[b]) << q;
                ASSERT_EQ(after.temperature[a], before.temperature[b]);
            }
        }
    }
}

TEST(Usda, HasTimeSamplesOfOneTopology) {
    const std::vector<KeptFrame> frames = with_last_topology(burn(30));
    const UsdaStage stage = written(scene_of(frames));
    EXPECT_EQ(stage.metadata.at("metersPerUnit"), "1");
    EXPECT_EQ(stage.metadata.at("upAxis"), "Y");
    EXPECT_EQ(stage.metadata.at("timeCodesPerSecond"), "10");
    EXPECT_EQ(stage.metadata.at("startTimeCode"), "5");
    EXPECT_EQ(stage.metadata.at("endTimeCode"), "34");
    const UsdaPrim& root = stage.prims.at(stage.metadata.at("defaultPrim"));
    const UsdaPrim& sheet = root.children.at("Sheet_1");
    EXPECT_EQ(sheet.type, "Mesh");
    const std::size_t points = frames[0].sheets[0].points.size(), quads = 12 * 18;
    EXPECT_EQ(sheet.attributes.at("faceVertexCounts").samples.at(-1).size(), quads);
    EXPECT_EQ(sheet.attributes.at("faceVertexIndices").samples.at(-1).size(), 4 * quads);
    EXPECT_EQ(sheet.attributes.at("primvars:st").samples.at(-1).size(), 8 * quads);
    EXPECT_EQ(sheet.attributes.at("primvars:st").interpolation, "faceVarying");
    for (const auto& [name, width] : {std::pair{"points", 3u},
                                      {"primvars:temperature", 1u},
                                      {"primvars:mass", 1u},
                                      {"primvars:phase", 1u},
                                      {"primvars:age", 1u}}) {
        const UsdaAttribute& attribute = sheet.attributes.at(name);
        ASSERT_EQ(attribute.samples.size(), 30u) << name;
        for (const auto& [time, values] : attribute.samples)
            EXPECT_EQ(values.size(), width * points) << name << time;
        if (width == 1) {
            EXPECT_EQ(attribute.interpolation, "vertex");
        }
    }
    const auto& last = sheet.attributes.at("points").samples.at(34);
    for (std::size_t n = 0; n < points; ++n) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_EQ(static_cast<float>(last[3 * n + axis]), frames[29].sheets[0].points[n][axis]);
    }
    EXPECT_EQ(root.children.at("Fire").type, "Points");
    EXPECT_EQ(root.children.at("Fire").attributes.at("ids").samples.at(34).size(),
              frames[29].particles.points.size());
}

TEST(Usda, MayHaveATopologyPerFrame) {
    const std::vector<KeptFrame> frames = burn(30);
    const UsdaStage stage = written(scene_of(frames));
    const UsdaPrim& sheet = stage.prims.at("Emberleaf").children.at("Sheet_1");
    const auto& indices = sheet.attributes.at("faceVertexIndices").samples;
    ASSERT_EQ(indices.size(), 30u);
    for (const auto& [time, values] : indices) {
        const auto& points = sheet.attributes.at("points").samples.at(time);
        EXPECT_EQ(*std::max_element(values.begin(), values.end()) + 1,
                  static_cast<double>(points.size()) / 3);
    }
}

TEST(Usda, TheCameraSeesWhatOursSees) {
    const UsdaScene scene = scene_of(with_last_topology(burn(3)));
    const UsdaPrim camera = written(scene).prims.at("Emberleaf").children.at("Camera");
    const auto& m = camera.attributes.at("xformOp:transform").samples.at(7);
    ASSERT_EQ(m.size(), 16u);
    const Camera ours = make_camera(scene.cameras[2].params, 160, 90);
    for (int axis = 0; axis < 3; ++axis)  // the last row is where it stands
        EXPECT_NEAR(m[12 + static_cast<std::size_t>(axis)], ours.eye[axis], 1e-5);
    // and it looks along its own -z, at the target
    const Eigen::Vector3f back(static_cast<float>(m[8]), static_cast<float>(m[9]),
                               static_cast<float>(m[10]));
    const CameraParams& p = scene.cameras[2].params;
    const Eigen::Vector3f target(static_cast<float>(p.target_x), static_cast<float>(p.target_y),
                                 static_cast<float>(p.target_z));
    EXPECT_NEAR(((ours.eye - target).normalized() - back).norm(), 0, 1e-5);
    const double focal = camera.attributes.at("focalLength").samples.at(7)[0];
    const double high = camera.attributes.at("verticalAperture").samples.at(-1)[0];
    EXPECT_NEAR(2 * std::atan(high / 2 / focal), p.field_of_view, 1e-5);
}

TEST(MeshFiles, PlyAndObjHoldPointsFacesAndCoordinates) {
    const std::vector<KeptFrame> frames = burn(20);
    const MeshFrame mesh = joined({frames[19].sheets[0], frames[0].sheets[0]});
    const Ply ply = read_ply(mesh_ply(mesh));
    ASSERT_EQ(ply.vertex.at("x").size(), mesh.points.size());
    ASSERT_EQ(ply.faces.size(), 2u * 12 * 18);
    EXPECT_EQ(ply.faces.back()[2], mesh.quads.back()[2]);
    EXPECT_EQ(ply.vertex.at("y").back(), static_cast<double>(mesh.points.back()[1]));
    EXPECT_EQ(ply.vertex.at("age")[0], -1.0);
    std::istringstream obj(mesh_obj(mesh));
    std::size_t points = 0, coordinates = 0, faces = 0;
    for (std::string line; std::getline(obj, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        points += kind == "v" ? 1u : 0u;
        coordinates += kind == "vt" ? 1u : 0u;
        faces += kind == "f" ? 1u : 0u;
        for (std::string corner; kind == "f" && words >> corner;) {
            const std::size_t slash = corner.find('/');
            EXPECT_LE(std::stoul(corner.substr(0, slash)), points);
            EXPECT_LE(std::stoul(corner.substr(slash + 1)), coordinates);
        }
    }
    EXPECT_EQ(points, mesh.points.size());
    EXPECT_EQ(faces, mesh.quads.size());
}

TEST(MeshFiles, APointCacheHasItsHeaderAndEveryPoint) {
    std::vector<MeshFrame> meshes;
    for (const KeptFrame& frame : with_last_topology(burn(20)))
        meshes.push_back(frame.sheets[0]);
    const std::string bytes = point_cache(meshes, 3);
    std::size_t at = 12;
    EXPECT_EQ(bytes.substr(0, at), std::string("POINTCACHE2\0", 12));
    EXPECT_EQ(take<std::int32_t>(bytes, at), 1);
    EXPECT_EQ(take<std::int32_t>(bytes, at), static_cast<int>(meshes[0].points.size()));
    EXPECT_EQ(take<float>(bytes, at), 3.0f);
    EXPECT_EQ(take<float>(bytes, at), 1.0f);
    EXPECT_EQ(take<std::int32_t>(bytes, at), 20);
    EXPECT_EQ(bytes.size() - at, 20 * meshes[0].points.size() * 12);
    at += 7 * meshes[0].points.size() * 12;
    EXPECT_EQ(take<float>(bytes, at), meshes[7].points[0][0]);
}

TEST(Geometry, ATubesCoordinatesDoNotRunBackAtItsSeam) {
    Params p;
    p.sheet.shape = SheetShape::Cylinder;
    p.sheet.rows = 8;
    p.sheet.columns = 6;
    const World world = make_world(p);
    const MeshFrame mesh = mesh_of(world.view().sheets[0], 0);
    EXPECT_TRUE(mesh.closed);
    float most = 0;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        float low = 2, high = -1;
        for (std::size_t c = 0; c < 4; ++c) {
            low = std::min(low, corner_uv(mesh, q, c)[0]);
            high = std::max(high, corner_uv(mesh, q, c)[0]);
        }
        EXPECT_NEAR(high - low, 1.0f / 8, 1e-6f);
        most = std::max(most, high);
    }
    EXPECT_EQ(most, 1.0f);
}

}  // namespace
}  // namespace ember
