// How the program ends.
#pragma once

#include <stdexcept>
#include <string>

namespace ember {

inline constexpr int kOk = 0;
inline constexpr int kRunFailed = 1;         ///< I/O, GL, numerics
inline constexpr int kBadInput = 2;          ///< usage or preset
inline constexpr int kComparisonFailed = 3;  ///< what was measured is not as required

/// Ends the program with kBadInput; the message is complete, one problem per line.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Ends the program with kRunFailed.
class RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace ember
