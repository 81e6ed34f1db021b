#include "sim/scene.h"

namespace ember {

Scene make_scene(const SheetParams& params) {
    Scene scene;
    for (int i = 0; i < params.count; ++i) {
        SheetPlan plan;
        plan.rows = params.rows;
        plan.columns = params.columns;
        plan.width = params.width;
        plan.height = params.height;
        plan.shape = params.shape;
        plan.border = params.border;
        plan.held = params.held;
        plan.imperfection = params.imperfection;
        const double behind = i * params.gap;
        if (params.pose == SheetPose::Hanging) {
            // main direction downwards, cross direction to the right, facing the viewer (+z)
            plan.main = -Vector3::UnitY();
            plan.cross = Vector3::UnitX();
            plan.origin = {-0.5 * params.width, params.elevation, -behind};
        } else {
            // main direction to the right, cross direction towards the viewer; stacked upwards
            plan.main = Vector3::UnitX();
            plan.cross = Vector3::UnitZ();
            plan.origin = {-0.5 * params.height, params.elevation + behind, -0.5 * params.width};
        }
        scene.sheets.push_back(plan);
    }
    return scene;
}

}  // namespace ember
