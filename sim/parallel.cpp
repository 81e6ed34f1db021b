#include "sim/parallel.h"

namespace ember {
namespace {

constexpr std::ptrdiff_t kItemsWorthSharing = 16384;

// A tick is a hundred short loops with next to nothing between them, so a worker looks out for the
// next one for some microseconds before it asks the system to sleep, which takes longer than that.
constexpr int kSpins = 4000;

void pause() {
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) {
    for (int part = 1; part < threads; ++part) {
        workers_.emplace_back([this, part] { work(part); });
    }
}

ThreadPool::~ThreadPool() {
    stop_ = true;
    ++round_;
    round_.notify_all();
    for (std::thread& worker : workers_)
        worker.join();
}

void ThreadPool::for_rows(std::ptrdiff_t rows, std::ptrdiff_t items_per_row,
                          const LoopBody<std::ptrdiff_t, std::ptrdiff_t>& body) {
    for_parts(rows, items_per_row,
              [&](int, std::ptrdiff_t begin, std::ptrdiff_t end) { body(begin, end); });
}

int ThreadPool::parts(std::ptrdiff_t rows, std::ptrdiff_t items_per_row) const {
    return rows * items_per_row < kItemsWorthSharing ? 1 : size();
}

void ThreadPool::for_parts(std::ptrdiff_t rows, std::ptrdiff_t items_per_row,
                           const LoopBody<int, std::ptrdiff_t, std::ptrdiff_t>& body) {
    if (parts(rows, items_per_row) == 1) return body(0, 0, rows);
    body_ = &body;
    rows_ = rows;
    running_ = static_cast<int>(workers_.size());
    ++round_;  // publishes the three above
    round_.notify_all();
    run_part(0);
    for (int spin = 0; running_ != 0; ++spin) {
        if (spin < kSpins) {
            pause();
        } else {
            std::this_thread::yield();
        }
    }
}

void ThreadPool::run_part(int part) {
    (*body_)(part, begin_of(part, size(), rows_), begin_of(part + 1, size(), rows_));
}

void ThreadPool::work(int part) {
    for (unsigned seen = 0;;) {
        for (int spin = 0; spin < kSpins && round_ == seen; ++spin)
            pause();
        round_.wait(seen);
        if (stop_) return;
        seen = round_;
        run_part(part);
        --running_;
    }
}

}  // namespace ember
