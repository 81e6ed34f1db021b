// Runs the emberleaf program itself, as people do.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace ember {

struct ChildResult {
    int code = -1;  ///< exit code; 1000 + signal when a signal ended it
    std::string out, err;
};

struct ChildOptions {
    std::string folder = ".";              ///< where it runs
    std::vector<std::string> environment;  ///< "NAME=value", or "NAME" to unset
    /// Once `wait_for` exists, `signal` is sent (0: none).
    std::string wait_for;
    int signal = 0;
};

[[nodiscard]] ChildResult run_emberleaf(const std::vector<std::string>& arguments,
                                        const ChildOptions& options = {});

}  // namespace ember
