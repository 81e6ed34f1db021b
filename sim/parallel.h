// A small pool of threads for loops whose iterations do not depend on each other.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace ember {

/// Refers to a function object that lives longer. A std::function would allocate room for what
/// loops capture, twice per sub-step.
template <class... Arguments>
class LoopBody {
  public:
    template <class Function>
    LoopBody(const Function& function)
        : function_(&function), call_([](const void* f, Arguments... arguments) {
              (*static_cast<const Function*>(f))(arguments...);
          }) {}
    void operator()(Arguments... arguments) const { call_(function_, arguments...); }

  private:
    const void* function_;
    void (*call_)(const void*, Arguments...);
};

/// Splits loops over rows between threads. Rows must write only what no other row touches; then
/// results do not depend on the number of threads.
class ThreadPool {
  public:
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] int size() const { return static_cast<int>(workers_.size()) + 1; }

    /// Calls body(begin, end) for parts that cover [0, rows); returns when all are done. Loops of
    /// less than `items_per_row * rows` = 16384 items run on the calling thread: starting the
    /// others costs more than they would save.
    void for_rows(std::ptrdiff_t rows, std::ptrdiff_t items_per_row,
                  const LoopBody<std::ptrdiff_t, std::ptrdiff_t>& body);

    /// The same with the number of the part, 0 .. size()-1, for scratch of its own.
    void for_parts(std::ptrdiff_t rows, std::ptrdiff_t items_per_row,
                   const LoopBody<int, std::ptrdiff_t, std::ptrdiff_t>& body);

    /// Into how many parts for_parts() splits such a loop, and where each begins.
    [[nodiscard]] int parts(std::ptrdiff_t rows, std::ptrdiff_t items_per_row) const;
    [[nodiscard]] static std::ptrdiff_t begin_of(int part, int parts, std::ptrdiff_t rows) {
        return rows * part / parts;
    }

  private:
    void work(int part);
    void run_part(int part);

    std::vector<std::thread> workers_;
    const LoopBody<int, std::ptrdiff_t, std::ptrdiff_t>* body_ = nullptr;
    std::ptrdiff_t rows_ = 0;
    std::atomic<unsigned> round_ = 0;  ///< counts loops
    std::atomic<int> running_ = 0;     ///< workers that have not finished the present loop
    std::atomic<bool> stop_ = false;
};

}  // namespace ember
