#include "app/shot_pipeline.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/bounded_queue.h"
#include "app/interrupt.h"

namespace ember {
namespace {

constexpr std::size_t kWaiting = 2;  // pictures between two parts

// Adds the time from construction to destruction.
class Busy {
  public:
    explicit Busy(double& seconds) : seconds_(seconds) {}
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
    ~Busy() {
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
        seconds_ += taken.count();
    }

  private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

// What a picture needs to be drawn.
struct ShotPipeline::Exposure {
    PlannedPicture planned;
    std::vector<PictureSink*> sinks;  // that lack it
    PictureSink* keeper = nullptr;    // has the image already
    bool image = false, layers = false;
    std::vector<FrameView> samples;
};

struct ShotPipeline::Drawn {
    Picture picture;
    std::vector<PictureSink*> sinks;
};

ShotPipeline::ShotPipeline(FrameSource& source, FramePainter& painter, const RenderJob& job,
                           Sinks& sinks, int samples, std::function<void(long)> done)
    : source_(source),
      painter_(painter),
      job_(job),
      sinks_(sinks),
      samples_(samples),
      told_(std::move(done)) {}

void ShotPipeline::skip_existing(const std::vector<PlannedPicture>& pictures) {
    for (const PlannedPicture& picture : pictures) {
        std::vector<bool>& row = present_.emplace_back();
        for (const auto& sink : sinks_)
            row.push_back(sink->has(picture.number, picture.time));
        if (std::find(row.begin(), row.end(), true) != row.end()) ++skipped_;
    }
}

std::vector<PictureSink*> ShotPipeline::lacking(std::size_t picture) const {
    std::vector<PictureSink*> sinks;
    for (std::size_t s = 0; s < sinks_.size(); ++s) {
        if (present_.empty() || !present_[picture][s]) sinks.push_back(sinks_[s].get());
    }
    return sinks;
}

std::optional<ShotPipeline::Exposure> ShotPipeline::simulate(const PlannedPicture& planned,
                                                             std::size_t i) {
    const Busy busy(times_.simulating);
    Exposure exposure{planned, lacking(i), nullptr, false, false, {}};
    for (std::size_t s = 0; s < sinks_.size(); ++s) {
        const bool there = !present_.empty() && present_[i][s];
        if (there && !sinks_[s]->wants_layers()) exposure.keeper = sinks_[s].get();
    }
    for (const PictureSink* sink : exposure.sinks)
        (sink->wants_layers() ? exposure.layers : exposure.image) = true;
    if (!exposure.layers && (!exposure.image || exposure.keeper != nullptr)) return exposure;
    const int samples = planned.exposure > 0 ? samples_ : 1;
    for (int k = 0; k < samples; ++k) {
        const double late = samples > 1 ? planned.exposure * (k + 0.5) / samples : 0;
        FrameView& sample = exposure.samples.emplace_back();
        if (!source_.show(planned.time + late, sample)) return std::nullopt;
        source_.detach(sample);
    }
    return exposure;
}

ShotPipeline::Drawn ShotPipeline::draw(const Exposure& exposure) {
    const Busy busy(times_.drawing);
    const bool kept = exposure.image && exposure.keeper != nullptr;
    Drawn drawn{{}, exposure.sinks};
    drawn.picture = painter_.paint(job_, exposure.planned, exposure.samples,
                                   exposure.image && !kept, exposure.layers);
    if (kept) {
        std::optional<Image> image = exposure.keeper->kept(exposure.planned.number);
        if (image) drawn.picture.image = std::move(*image);
    }
    return drawn;
}

void ShotPipeline::encode(const Drawn& drawn) {
    {
        const Busy busy(times_.encoding);
        for (PictureSink* sink : drawn.sinks)
            sink->put(drawn.picture);
    }
    told_(++done_);
}

void ShotPipeline::keep(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (error_ == nullptr) error_ = std::move(error);
}

void ShotPipeline::one_by_one(const std::vector<PlannedPicture>& pictures) {
    for (std::size_t i = 0; i < pictures.size() && interrupt_signal() == 0; ++i) {
        std::optional<Exposure> exposure = simulate(pictures[i], i);
        if (!exposure) {
            diverged_ = true;
            return;
        }
        encode(draw(*exposure));
    }
}

void ShotPipeline::overlapped(const std::vector<PlannedPicture>& pictures) {
    BoundedQueue<Exposure> exposures(kWaiting);
    BoundedQueue<Drawn> drawings(kWaiting);
    // whatever happens to one part, the others come to their end
    const auto guarded = [&](const std::function<void()>& work) {
        try {
            work();
        } catch (...) {
            keep(std::current_exception());
            exposures.close();
            drawings.close();
        }
    };
    std::thread simulating([&] {
        guarded([&] {
            bool wanted = true;
            for (std::size_t i = 0; wanted && i < pictures.size() && interrupt_signal() == 0; ++i) {
                std::optional<Exposure> exposure = simulate(pictures[i], i);
                diverged_ = !exposure;
                wanted = exposure && exposures.push(std::move(*exposure));
            }
        });
        exposures.close();
    });
    std::thread encoding([&] {
        guarded([&] {
            while (const std::optional<Drawn> drawn = drawings.pop())
                encode(*drawn);
        });
    });
    guarded([&] {
        while (const std::optional<Exposure> exposure = exposures.pop()) {
            if (!drawings.push(draw(*exposure)) || interrupt_signal() != 0) break;
        }
    });
    exposures.close();
    drawings.close();
    simulating.join();
    encoding.join();
}

bool ShotPipeline::run(const std::vector<PlannedPicture>& pictures, bool overlap) {
    if (overlap) {
        overlapped(pictures);
    } else {
        one_by_one(pictures);
    }
    if (error_ != nullptr) std::rethrow_exception(error_);
    return !diverged_;
}

}  // namespace ember
