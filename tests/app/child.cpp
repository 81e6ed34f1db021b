#include "child.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "temporary_folder.h"

namespace ember {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

[[noreturn]] void become_emberleaf(const std::vector<std::string>& arguments,
                                   const ChildOptions& options, const TemporaryFolder& log) {
    const int out = ::open((log / "out").c_str(), O_WRONLY | O_CREAT, 0600);
    const int err = ::open((log / "err").c_str(), O_WRONLY | O_CREAT, 0600);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    for (const std::string& entry : options.environment) {
        const std::size_t equals = entry.find('=');
        if (equals == std::string::npos) {
            ::unsetenv(entry.c_str());
        } else {
            ::setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
        }
    }
    std::vector<char*> words{const_cast<char*>(EMBERLEAF_BINARY)};
    for (const std::string& word : arguments)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (::chdir(options.folder.c_str()) == 0) ::execv(EMBERLEAF_BINARY, words.data());
    std::_Exit(127);
}

}  // namespace

ChildResult run_emberleaf(const std::vector<std::string>& arguments, const ChildOptions& options) {
    const TemporaryFolder log;
    const pid_t child = ::fork();
    if (child == 0) become_emberleaf(arguments, options, log);
    int status = 0;
    bool ended = false;
    while (options.signal != 0 && !ended && !std::filesystem::exists(options.wait_for)) {
        ended = ::waitpid(child, &status, WNOHANG) == child;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (options.signal != 0 && !ended) ::kill(child, options.signal);
    if (!ended) ::waitpid(child, &status, 0);
    ChildResult result{0, text_of(log / "out"), text_of(log / "err")};
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    return result;
}

}  // namespace ember
