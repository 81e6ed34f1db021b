// Undo and redo: one entry for each gesture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/document.h"

namespace ember {

class EditHistory {
  public:
    static constexpr std::size_t kMostEntries = 500;

    /// What there is before anything is edited.
    void start(const PresetValues& values);

    /// Called when no hand is on anything: what has changed since the last call, however many
    /// movements that took, becomes one entry. How things are looked at is no edit.
    void settle(const PresetValues& values);

    /// Takes over values that came about otherwise, without an entry.
    void adopt(const PresetValues& values) { settled_ = values; }

    /// The values before the last entry, with the present camera; empty when there is none.
    [[nodiscard]] std::optional<PresetValues> undo(const PresetValues& now);
    [[nodiscard]] std::optional<PresetValues> redo(const PresetValues& now);

    /// "paper.grammage: 80 g/m² to 120 g/m²"; empty when there is nothing to undo or redo.
    [[nodiscard]] std::string undo_text() const;
    [[nodiscard]] std::string redo_text() const;
    [[nodiscard]] std::size_t size() const { return done_.size(); }

  private:
    struct Entry {
        PresetValues before, after;
        std::string text;
    };
    PresetValues with_view_of(const PresetValues& now);
    PresetValues settled_;
    std::vector<Entry> done_, undone_;
};

}  // namespace ember
