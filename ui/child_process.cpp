#include "ui/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace ember {
namespace {

constexpr std::size_t kMostOutput = 1 << 20;  // [bytes]
constexpr int kPatience = 200;                // [10 ms] for a child that has been asked to end

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, int niceness) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw std::runtime_error(words[0] + ": " + std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 2);
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error =
        posix_spawnp(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    pipe_ = ends[0];
    fcntl(pipe_, F_SETFL, O_NONBLOCK);
    if (error != 0) {
        close(pipe_);
        throw std::runtime_error(words[0] + ": " + std::strerror(error));
    }
    if (niceness != 0) setpriority(PRIO_PROCESS, static_cast<id_t>(pid_), niceness);
}

ChildProcess::~ChildProcess() {
    terminate();
    for (int i = 0; !poll() && i < kPatience; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (!code_) {  // it has no file in half: they get their names when they are whole
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    close(pipe_);
}

void ChildProcess::read() {
    char text[4096];
    for (ssize_t got = 0; (got = ::read(pipe_, text, sizeof text)) > 0;) {
        output_.append(text, static_cast<std::size_t>(got));
        if (output_.size() > kMostOutput) output_.erase(0, output_.size() - kMostOutput / 2);
    }
}

std::optional<int> ChildProcess::poll() {
    if (code_) return code_;
    read();
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    read();
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return code_;
}

void ChildProcess::terminate() {
    if (!code_) kill(pid_, SIGTERM);
}

std::string own_program() {
    return std::filesystem::read_symlink("/proc/self/exe").string();
}

std::string command_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        constexpr const char* kPlain =
            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%^";
        if (!line.empty()) line += ' ';
        if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word)
            line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

}  // namespace ember
