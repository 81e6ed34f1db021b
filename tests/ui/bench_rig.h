// A workbench with a small preset of its own, in a folder that lasts as long as a test.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include "../app/temporary_folder.h"
#include "ui/workbench.h"

namespace ember {

inline constexpr const char* kPreset =
    "schema = 1\ntitle = \"small\"\n\n[sheet]\nrows = 12\ncolumns = 16\n"
    "\n[paper]\ngrammage = 80  # as in the office\n";

class AtTheBench : public ::testing::Test {
  protected:
    void SetUp() override {
        file_ = folder_.write("small.toml", kPreset);
        const auto at = [&](const char* name) { return folder_.path() / name; };
        folders_ = {at("config"), at("presets"),  at("cache"),
                    at("state"),  at("pictures"), at("videos")};
        bench_ = std::make_unique<Workbench>(open_document(file_), folders_, Settings(), 1);
        bench_->act(Action::TogglePlay);  // it begins by playing
        bench_->act(Action::ToStart);
        frames();
    }
    // Lets frames pass until everything that was asked for has happened.
    void frames() {
        for (int i = 0; i < 2000; ++i) {
            time_ += 0.016;
            bench_->begin_frame(time_, busy_);
            bench_->end_frame(busy_);
            if (bench_->caught_up() && i > 1) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        FAIL() << "the session does not answer";
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i)
            bench_->act(Action::Step);
        frames();
    }
    // A slider that is dragged and let go.
    void drag_grammage(double to) {
        for (const double share : {0.3, 0.6, 1.0}) {
            double& grammage = bench_->values.params.paper.grammage;
            grammage += share * (to - grammage);
            bench_->apply();
            time_ += 0.016;
            bench_->begin_frame(time_, true);
            bench_->end_frame(true);
        }
        frames();
    }
    [[nodiscard]] std::string said() const {
        return bench_->notices.all().empty() ? "" : bench_->notices.all().back().text;
    }
    static std::string read(const std::filesystem::path& path) {
        std::ifstream in(path);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    TemporaryFolder folder_;
    std::filesystem::path file_;
    UserFolders folders_;
    std::unique_ptr<Workbench> bench_;
    double time_ = 0;
    bool busy_ = false;  // a hand is on something
};

}  // namespace ember
