#include "ui/edit_history.h"

#include <utility>

namespace ember {
namespace {

std::string text_of(const std::vector<ShownChange>& changes) {
    const ShownChange& first = changes.front();
    std::string text = first.key + ": " + first.from + " to " + first.to;
    if (changes.size() > 1) text += ", and " + std::to_string(changes.size() - 1) + " more";
    return text;
}

}  // namespace

void EditHistory::start(const PresetValues& values) {
    settled_ = values;
    done_.clear();
    undone_.clear();
}

void EditHistory::settle(const PresetValues& values) {
    const std::vector<ShownChange> changes = shown_changes(settled_, values, false);
    if (changes.empty()) return;
    done_.push_back({std::exchange(settled_, values), values, text_of(changes)});
    if (done_.size() > kMostEntries) done_.erase(done_.begin());
    undone_.clear();
}

std::optional<PresetValues> EditHistory::undo(const PresetValues& now) {
    settle(now);  // a gesture that has not ended yet
    if (done_.empty()) return std::nullopt;
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    settled_ = undone_.back().before;
    return with_view_of(now);
}

std::optional<PresetValues> EditHistory::redo(const PresetValues& now) {
    if (!shown_changes(settled_, now, false).empty()) settle(now);  // drops what was undone
    if (undone_.empty()) return std::nullopt;
    done_.push_back(std::move(undone_.back()));
    undone_.pop_back();
    settled_ = done_.back().after;
    return with_view_of(now);
}

PresetValues EditHistory::with_view_of(const PresetValues& now) {
    settled_.render.camera = now.render.camera;
    settled_.render.view = now.render.view;
    settled_.render.shot = now.render.shot;
    return settled_;
}

std::string EditHistory::undo_text() const {
    return done_.empty() ? "" : done_.back().text;
}

std::string EditHistory::redo_text() const {
    return undone_.empty() ? "" : undone_.back().text;
}

}  // namespace ember
