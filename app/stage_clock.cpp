#include "app/stage_clock.h"

namespace ember {

void StageClock::begin(Stage) {
    start_ = std::chrono::steady_clock::now();
}

void StageClock::end(Stage stage) {
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start_;
    ms_[index_of(stage)] += taken.count();
}

}  // namespace ember
