// A block of numbers that begins at a cache line, so that whole vectors are loaded from one line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

namespace ember {

class AlignedArray {
  public:
    /// Makes room for `size` numbers and sets them all to 0. Allocates only to grow.
    void assign_zero(std::size_t size) {
        reserve(size);
        std::fill_n(data_.get(), size, 0.0);
        size_ = size;
    }
    /// Makes room for `size` numbers whose values mean nothing.
    void resize(std::size_t size) {
        reserve(size);
        size_ = size;
    }
    [[nodiscard]] double* data() { return data_.get(); }
    [[nodiscard]] const double* data() const { return data_.get(); }
    [[nodiscard]] std::size_t size() const { return size_; }

  private:
    static constexpr std::align_val_t kCacheLine{64};
    struct Free {
        void operator()(double* p) const { ::operator delete[](p, kCacheLine); }
    };
    void reserve(std::size_t size) {
        if (size <= capacity_) return;
        data_.reset(static_cast<double*>(::operator new[](size * sizeof(double), kCacheLine)));
        capacity_ = size;
    }

    std::unique_ptr<double[], Free> data_;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace ember
