// What was done, kept on disk until it is saved or given up, in case the program ends otherwise.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ember {

/// One per window. Its file is named after the process, so that windows do not take each other's.
class Recovery {
  public:
    static constexpr double kEvery = 10.0;  ///< [s]

    explicit Recovery(std::filesystem::path folder);

    /// Takes that processes which are no more have left; they are renamed so that they stay.
    [[nodiscard]] std::vector<std::filesystem::path> left_behind() const;
    /// Whether it is time to keep() again.
    [[nodiscard]] bool due(double now) const { return now - kept_ >= kEvery; }
    /// Writes `take` unless it is what was kept last. Throws std::runtime_error.
    void keep(const std::string& take, double now);
    /// There is nothing to lose any more.
    void forget();

  private:
    std::filesystem::path folder_, file_;
    std::string text_;
    double kept_ = 0;  // [s]
};

}  // namespace ember
