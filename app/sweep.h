// Runs the cases of a sweep and puts their pictures and figures together.
#pragma once

#include "app/frame_painter.h"
#include "app/sweep_plan.h"

namespace ember {

struct SweepOptions {
    RenderOptions shot;
    std::vector<std::string> vary;
    std::string output, array = "1/1";
    SweepShare share;
    int jobs = 1;
};

/// Every case leaves a picture that carries its figures; a case whose picture is there with the
/// same hash is not run again. So a sweep goes on where it was ended, its shares may be run by
/// several machines that have a folder in common, and the result never depends on how it was
/// divided.
class Sweep {
  public:
    /// Reads all cases. Throws InputError.
    Sweep(const SweepOptions& options, const std::vector<SweepAxis>& axes);

    /// Runs what this share lacks, several cases at a time, until an interrupt.
    void run();

    /// Writes sheet and table when all cases are there, and says so or how many are missing.
    [[nodiscard]] std::string assemble();

  private:
    struct Case {
        SweepCase values;
        RenderJob job;
        PlannedPicture picture;
        ImageText text;  // what its picture says
        std::string file;
    };
    struct Burnt;

    [[nodiscard]] bool is_there(const Case& item) const;
    [[nodiscard]] Burnt burn(const Case& item) const;
    void draw(const Burnt& burnt);

    const SweepOptions& options_;
    FramePainter painter_;
    std::vector<Case> cases_;
    int columns_ = 1;
};

}  // namespace ember
