// Undo and redo.
#include <gtest/gtest.h>

#include "ui/edit_history.h"

namespace ember {
namespace {

TEST(EditHistory, AGestureIsOneEntryHoweverManyMovements) {
    EditHistory history;
    PresetValues values;
    history.start(values);
    const double before = values.params.paper.grammage;
    for (int i = 0; i < 30; ++i)
        values.params.paper.grammage += 0.001;  // nobody settles while the hand is on it
    history.settle(values);
    history.settle(values);
    EXPECT_EQ(history.size(), 1u);
    EXPECT_EQ(history.undo_text(), "paper.grammage: 80 g/m\u00b2 to 110 g/m\u00b2");
    const auto undone = history.undo(values);
    ASSERT_TRUE(undone);
    EXPECT_EQ(undone->params.paper.grammage, before);
    EXPECT_FALSE(history.undo(*undone));
    const auto redone = history.redo(*undone);
    ASSERT_TRUE(redone);
    EXPECT_EQ(redone->params.paper.grammage, values.params.paper.grammage);
    EXPECT_FALSE(history.redo(*redone));
}

TEST(EditHistory, UndoEndsAGestureThatHasNotEnded) {
    EditHistory history;
    PresetValues values;
    history.start(values);
    values.params.paper.c_s = 0.5;
    const auto undone = history.undo(values);
    ASSERT_TRUE(undone);
    EXPECT_EQ(undone->params.paper.c_s, Params().paper.c_s);
    EXPECT_EQ(history.redo_text().find("paper.c_s: "), 0u);
}

TEST(EditHistory, ANewEditDropsWhatWasUndone) {
    EditHistory history;
    PresetValues values;
    history.start(values);
    values.params.paper.c_s = 0.5;
    history.settle(values);
    values = *history.undo(values);
    values.params.wind.x = 1;
    history.settle(values);
    EXPECT_FALSE(history.redo(values));
    EXPECT_EQ(history.size(), 1u);
}

TEST(EditHistory, TheCameraIsNoEditAndIsNotMovedByUndo) {
    EditHistory history;
    PresetValues values;
    history.start(values);
    values.render.camera.azimuth += 1;
    history.settle(values);
    EXPECT_EQ(history.size(), 0u);
    values.render.view.mode = ViewMode::Stress;
    history.settle(values);
    EXPECT_EQ(history.size(), 0u) << "nor is the view";
    values.render.look.exposure = 2;
    history.settle(values);
    EXPECT_EQ(history.size(), 1u);
    values.render.camera.azimuth += 1;
    const auto undone = history.undo(values);
    ASSERT_TRUE(undone);
    EXPECT_EQ(undone->render.look.exposure, 1);
    EXPECT_EQ(undone->render.camera.azimuth, values.render.camera.azimuth);
}

TEST(EditHistory, WhatCameAboutOtherwiseIsTakenOver) {
    EditHistory history;
    PresetValues values;
    history.start(values);
    values.params.paper.grammage = 0.2;
    history.adopt(values);
    history.settle(values);
    EXPECT_EQ(history.size(), 0u);
}

}  // namespace
}  // namespace ember
