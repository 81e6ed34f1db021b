#include "sim/parallel.h"

namespace ember {
namespace {
constexpr std::ptrdiff_t kItemsWorthSharing = 16384;
}

ThreadPool::ThreadPool(int threads) {
    for (int part = 1; part < threads; ++part) {
        workers_.emplace_back([this, part] { work(part); });
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    start_.notify_all();
    for (std::thread& worker : workers_)
        worker.join();
}

void ThreadPool::for_rows(std::ptrdiff_t rows, std::ptrdiff_t items_per_row,
                          const std::function<void(std::ptrdiff_t, std::ptrdiff_t)>& body) {
    if (workers_.empty() || rows * items_per_row < kItemsWorthSharing) {
        body(0, rows);
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        body_ = &body;
        rows_ = rows;
        running_ = static_cast<int>(workers_.size());
        ++generation_;
    }
    start_.notify_all();
    body(0, rows / size());
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return running_ == 0; });
}

void ThreadPool::work(int part) {
    std::size_t seen = 0;
    for (;;) {
        std::unique_lock lock(mutex_);
        start_.wait(lock, [&] { return stop_ || generation_ != seen; });
        if (stop_) return;
        seen = generation_;
        const auto* body = body_;
        const std::ptrdiff_t begin = rows_ * part / size(), end = rows_ * (part + 1) / size();
        lock.unlock();
        (*body)(begin, end);
        lock.lock();
        if (--running_ == 0) done_.notify_one();
    }
}

}  // namespace ember
