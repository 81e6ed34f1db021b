#include "sim/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "sim/math.h"
#include "sim/scene_check.h"

namespace ember {
namespace {

std::string group_of(const Params& params, std::size_t element) {
    return params.sheets.empty() ? "sheet" : "sheets." + std::to_string(element + 1);
}

// About the fixed axes, x first.
Eigen::Matrix3d rotation(const SheetParams& params) {
    const auto turn = [](double angle, int a, int b) {
        Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
        m(a, a) = m(b, b) = ember::cos(angle);
        m(b, a) = ember::sin(angle);
        m(a, b) = -m(b, a);
        return m;
    };
    return turn(params.turn_z, 0, 1) * turn(params.turn_y, 2, 0) * turn(params.turn_x, 1, 2);
}

void put_in_place(const SheetParams& params, int number, SheetPlan& plan) {
    const double behind = number * params.gap;
    Vector3 stack;
    if (params.pose == SheetPose::Hanging) {
        // main direction downwards, cross direction to the right, facing the viewer (+z)
        plan.main = -Vector3::UnitY();
        plan.cross = Vector3::UnitX();
        plan.origin = {-0.5 * params.width, params.elevation, -behind};
        stack = -behind * Vector3::UnitZ();
    } else {
        // main direction to the right, cross direction towards the viewer; stacked upwards
        plan.main = Vector3::UnitX();
        plan.cross = Vector3::UnitZ();
        plan.origin = {-0.5 * params.height, params.elevation + behind, -0.5 * params.width};
        stack = behind * Vector3::UnitY();
    }
    if (params.turn_x != 0 || params.turn_y != 0 || params.turn_z != 0) {
        Vector3 middle = plan.origin - stack + 0.5 * params.height * plan.main;
        if (params.shape == SheetShape::Flat) middle += 0.5 * params.width * plan.cross;
        const Eigen::Matrix3d turn = rotation(params);
        plan.origin = middle + turn * (plan.origin - middle);
        plan.main = turn * plan.main;
        plan.cross = turn * plan.cross;
    }
    const Vector3 move(params.x, params.y, params.z);
    if (move != Vector3::Zero()) plan.origin += move;
}

std::vector<std::uint8_t> cells_of(const Params& params, const SheetParams& sheet,
                                   const std::string& group) {
    if (sheet.mask.empty()) return {};
    const auto image = std::find_if(params.masks.begin(), params.masks.end(),
                                    [&](const auto& mask) { return mask->name == sheet.mask; });
    if (image == params.masks.end())
        throw SceneError(group + ".mask", "no picture \"" + sheet.mask + "\" has been read");
    std::vector<std::uint8_t> cells = paper_cells(**image, sheet.rows, sheet.columns);
    if (std::find(cells.begin(), cells.end(), 1) == cells.end()) {
        throw SceneError(group + ".mask", "\"" + sheet.mask +
                                              "\" leaves no paper on a lattice of " +
                                              std::to_string(sheet.rows) + " x " +
                                              std::to_string(sheet.columns) + " cells");
    }
    return cells;
}

}  // namespace

std::vector<SheetParams> sheets_of(const Params& params) {
    if (params.sheets.empty()) return {params.sheet};
    std::vector<SheetParams> sheets;
    for (const ParamOverrides& overrides : params.sheets) {
        Params one;
        one.sheet = params.sheet;
        for (const ParamOverride& o : overrides)
            o.row->assign(&one, o.value);
        sheets.push_back(one.sheet);
    }
    return sheets;
}

Scene make_scene(const Params& params) {
    static_cast<void>(count_nodes(params));
    const std::vector<SheetParams> elements = sheets_of(params);
    Scene scene;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const SheetParams& sheet = elements[i];
        SheetPlan plan;
        plan.group = group_of(params, i);
        plan.rows = sheet.rows;
        plan.columns = sheet.columns;
        plan.width = sheet.width;
        plan.height = sheet.height;
        plan.shape = sheet.shape;
        plan.border = sheet.border;
        plan.held = sheet.held;
        plan.held_points = sheet.held_points;
        plan.imperfection = sheet.imperfection;
        plan.gap = sheet.count > 1 ? sheet.gap : std::numeric_limits<double>::infinity();
        plan.paper = cells_of(params, sheet, plan.group);
        for (int number = 0; number < sheet.count; ++number) {
            plan.name = sheet.name.empty() ? "sheet " + std::to_string(scene.sheets.size() + 1)
                                           : '"' + sheet.name + '"';
            if (!sheet.name.empty() && sheet.count > 1)
                plan.name += ' ' + std::to_string(number + 1);
            put_in_place(sheet, number, plan);
            scene.sheets.push_back(plan);
        }
    }
    return scene;
}

}  // namespace ember
