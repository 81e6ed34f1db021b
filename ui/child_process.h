// A program that runs beside the window.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ember {

/// Runs a program found on PATH or given by path, without a shell; what it writes to stderr is
/// kept, its stdout is not. Ended (SIGTERM, as Ctrl-C ends a rendering) when destroyed.
class ChildProcess {
  public:
    /// Throws std::runtime_error with the reason when it cannot be started. `niceness` as of nice.
    explicit ChildProcess(const std::vector<std::string>& words, int niceness = 0);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Takes in what it has written since; returns its exit code once it has ended, 128 + signal
    /// where one ended it.
    std::optional<int> poll();
    /// Asks it to end.
    void terminate();
    /// All that it has written so far to stderr.
    [[nodiscard]] const std::string& output() const { return output_; }

  private:
    void read();
    int pid_ = -1, pipe_ = -1;
    std::optional<int> code_;
    std::string output_;
};

/// The file of the running program.
[[nodiscard]] std::string own_program();

/// Words as a person types them in a shell, quoted where they must be.
[[nodiscard]] std::string command_line(const std::vector<std::string>& words);

}  // namespace ember
