// Slots A and B: two sets of values, compared one after the other or side by side.
#include <utility>

#include "ui/workbench.h"

namespace ember {

void Workbench::act_on_slots(Action action) {
    switch (action) {
        case Action::SideBySide:
            shown.side_by_side = !shown.side_by_side;
            return put_beside(shown.side_by_side);
        case Action::Compare:
            shown.comparing = true;
            return put_beside(true);
        case Action::SwapSlots:
            return swap_slots();
        case Action::StoreSlot:
            other_ = values;
            renew_beside();
            return say(Severity::Info, "slots A and B are now the same");
        default:
            return;
    }
}

// The other slot burns beside this one from when somebody looks at it until they have had enough.
void Workbench::put_beside(bool wanted) {
    if (wanted == beside_) return;
    beside_ = wanted;
    session_.put_beside(wanted ? std::optional<Params>(other_.params) : std::nullopt);
}

void Workbench::renew_beside() {
    if (!beside_) return;
    beside_ = false;
    put_beside(true);
}

void Workbench::swap_slots() {
    const CameraParams camera = values.render.camera;
    std::swap(values, other_);
    values.render.camera = camera;
    slot_b_ = !slot_b_;
    renew_beside();
    apply();
}

}  // namespace ember
