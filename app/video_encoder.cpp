#include "app/video_encoder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "app/exit_code.h"
#include "app/film_format.h"
#include "app/preset_io/atomic_file.h"
#include "app/raw_sink.h"

extern char** environ;

namespace ember {
namespace {

constexpr off_t kLogTail = 1000;  // [bytes]

// A file without a name, for a child's messages: unlike a pipe, it never fills up.
int unnamed_file() {
    std::string name = std::filesystem::temp_directory_path() / "emberleaf-XXXXXX";
    const int file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(name.c_str());
    return file;
}

// The child gets the default signals and a process group of its own: an interrupt from the
// keyboard ends our loop, and we then let it finish the film.
int spawn(const std::vector<std::string>& command, int input, int errors, pid_t& process) {
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, errors, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    sigaddset(&defaults, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    const int error =
        posix_spawnp(&process, arguments.front(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

}  // namespace

VideoEncoder::VideoEncoder(std::filesystem::path path, const PictureFormat& format)
    : path_(std::move(path)), temporary_(temporary_name(path_)) {
    make_folder_of(path_);
    remove_stale_temporaries(path_.parent_path());
    if (std::filesystem::is_directory(path_)) throw RunError(path_.string() + ": is a folder");
    start(format);
}

void VideoEncoder::start(const PictureFormat& format) {
    std::array<int, 2> ends{};
    log_ = unnamed_file();
    if (log_ < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw RunError(path_.string() + ": cannot start ffmpeg: " + std::strerror(errno));
    }
    const FilmFormat* film = find_film_format(path_.extension().string());
    if (film == nullptr) throw RunError(path_.string() + ": no kind of film");
    // a name that begins with '-' would be taken for an option
    const std::string output = std::filesystem::absolute(temporary_).string();
    const int error = spawn(ffmpeg_command(*film, format, output), ends[0], log_, process_);
    ::close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return;
    ::close(pipe_);
    ::close(log_);
    throw RunError(error == ENOENT
                       ? path_.string() +
                             ": films need the ffmpeg program: sudo apt install ffmpeg, "
                             "or write pictures with -o frame_####.png"
                       : path_.string() + ": ffmpeg: " + std::strerror(error));
}

VideoEncoder::~VideoEncoder() {
    if (pipe_ >= 0) ::close(pipe_);
    if (process_ > 0) {
        ::kill(process_, SIGTERM);
        wait_for_end();
    }
    if (!finished_) ::unlink(temporary_.c_str());
    if (log_ >= 0) ::close(log_);
}

int VideoEncoder::wait_for_end() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
}

void VideoEncoder::fail(const std::string& reason) {
    const off_t size = ::lseek(log_, 0, SEEK_END);
    std::string tail(static_cast<std::size_t>(std::min(size, kLogTail)), '\0');
    const ssize_t count =
        ::pread(log_, tail.data(), tail.size(), size - static_cast<off_t>(tail.size()));
    tail.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    throw RunError(path_.string() + ": ffmpeg failed: " + (tail.empty() ? reason : tail));
}

void VideoEncoder::put(const Picture& picture) {
    const int error = write_bytes(pipe_, picture.image.rgba.data(), picture.image.rgba.size());
    if (error == 0) return;
    wait_for_end();  // so that its last words are in the log
    fail(std::strerror(error));
}

void VideoEncoder::finish() {
    ::close(pipe_);
    pipe_ = -1;
    const int status = wait_for_end();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("it ended abnormally");
    // it may end well although the end of the film was not written; it says so, and only errors
    if (::lseek(log_, 0, SEEK_END) > 0) fail("");
    publish_file(temporary_, path_);
    finished_ = true;
}

std::string VideoEncoder::where() const {
    return finished_ ? path_.string() : path_.string() + " (incomplete, removed)";
}

}  // namespace ember
