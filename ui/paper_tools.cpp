#include "ui/paper_tools.h"

#include <utility>

#include "sim/lighter.h"
#include "ui/lighter_placement.h"
#include "ui/pick.h"

namespace ember {
namespace {

constexpr double kBlowPerHeight = 8.0;    // [m/s] for a drag as long as the picture is high
constexpr double kPaintingTime = 3600.0;  // [s]
constexpr double kGrip = 0.040;           // [m] of paper in a hand
constexpr double kPullTime = 0.050;       // [s] in which it follows

}  // namespace

Vector3 PictureCamera::ray(const PicturePoint& at) const {
    return ray_through(camera, at.x, at.y, static_cast<int>(rect.width),
                       static_cast<int>(rect.height))
        .cast<double>();
}

Vector3 PictureCamera::beside(const Vector3& place, const PicturePoint& at) const {
    // the third row of the view matrix looks back at the camera
    const Vector3 back = camera.view.block<1, 3>(2, 0).transpose().cast<double>();
    const Vector3 direction = ray(at);
    return eye() + back.dot(place - eye()) / back.dot(direction) * direction;
}

void PaperTools::use(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench) {
    if (drag.drag == Drag::Ignite) return ignite(drag, picture, bench);
    if (drag.drag == Drag::Touch) return touch(drag, picture, bench);
    if (drag.drag == Drag::Blow) return blow(drag, picture, bench);
    if (drag.drag != Drag::PlaceLighter) return;
    const Snapshot& shot = bench.snapshot();
    const auto hit = pick(shot.view, shot.params, picture.eye(), picture.ray(drag.at));
    if (hit) bench.place_lighter(*hit);
}

// A lighter of its own follows the mouse over the paper.
void PaperTools::ignite(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench) {
    const Snapshot& shot = bench.snapshot();
    const auto hit = pick_sheet(shot.view, picture.eye(), picture.ray(drag.at));
    if (!painting_ && hit && !drag.ended) {
        const std::size_t edited = bench.lighter;
        bench.act(Action::AddLighter);
        brush_ = std::exchange(bench.lighter, edited);
        painting_ = true;
    }
    if (!painting_) return;
    LighterParams brush = bench.lighter_now(brush_);
    if (hit) move_lighter(brush, hit->place, brush.on && !drag.begun, shot.view.time);
    if (drag.begun) brush.start = shot.view.time;
    brush.duration = kPaintingTime;
    brush.on = !drag.ended;
    painting_ = !drag.ended;
    bench.change_lighter(brush_, brush);
}

void PaperTools::touch(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench) {
    HandParams& hand = bench.values.params.hand;
    const Snapshot& shot = bench.snapshot();
    if (drag.begun) {
        hand_ = hand;
        const auto hit = pick_sheet(shot.view, picture.eye(), picture.ray(drag.at));
        if (!hit) return;
        const SheetView& sheet = shot.view.sheets[hit->sheet];
        const Index site = sheet.site[hit->node];
        held_ = {sheet.x[hit->node], sheet.y[hit->node], sheet.z[hit->node]};
        hand.on = true;
        hand.sheet = static_cast<std::int64_t>(hit->sheet) + 1;
        hand.row = site / sheet.column_count;
        hand.column = site % sheet.column_count;
        hand.radius = kGrip;
        hand.response = kPullTime;
    }
    if (!hand.on) return;
    const Vector3 place = held_ + picture.beside(held_, drag.at) - picture.beside(held_, drag.from);
    hand.x = place.x(), hand.y = place.y(), hand.z = place.z();
    if (drag.ended) hand = hand_;  // as if it had never been there, but in the take
    bench.apply();
}

void PaperTools::blow(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench) {
    WindParams& wind = bench.values.params.wind;
    if (drag.begun) wind_ = wind;
    const double scale = kBlowPerHeight / picture.rect.height;
    const double right = scale * (drag.at.x - drag.from.x), up = scale * (drag.from.y - drag.at.y);
    const Eigen::Matrix4f& view = picture.camera.view;
    const Vector3 speed = right * view.block<1, 3>(0, 0).transpose().cast<double>() +
                          up * view.block<1, 3>(1, 0).transpose().cast<double>();
    wind = wind_;
    if (!drag.ended) wind.x += speed.x(), wind.y += speed.y(), wind.z += speed.z();
    bench.apply();
}

}  // namespace ember
