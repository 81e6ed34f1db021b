#include "app/video_encoder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "app/atomic_file.h"
#include "app/exit_code.h"

extern char** environ;

namespace ember {

VideoEncoder::VideoEncoder(std::filesystem::path path, int width, int height, double fps)
    : path_(std::move(path)) {
    make_folder_of(path_);
    temporary_ = temporary_name(path_);
    log_ = temporary_;
    log_ += ".log";
    const std::string size = std::to_string(width) + 'x' + std::to_string(height);
    const std::string rate = std::to_string(fps);
    // H.264 with 4:2:0 colour needs even sides
    const char* const arguments[] = {"ffmpeg",
                                     "-y",
                                     "-loglevel",
                                     "error",
                                     "-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgba",
                                     "-video_size",
                                     size.c_str(),
                                     "-framerate",
                                     rate.c_str(),
                                     "-i",
                                     "-",
                                     "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p",
                                     "-c:v",
                                     "libx264",
                                     "-crf",
                                     "18",
                                     "-movflags",
                                     "+faststart",
                                     temporary_.c_str(),
                                     nullptr};
    int pipe[2];
    if (::pipe2(pipe, O_CLOEXEC) != 0) throw RunError(std::string("pipe: ") + std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log_.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int error = ::posix_spawnp(&child_, "ffmpeg", &actions, nullptr,
                                     const_cast<char* const*>(arguments), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[0]);
    input_ = pipe[1];
    if (error == 0) return;
    ::close(input_);
    std::error_code ignored;
    std::filesystem::remove(log_, ignored);
    throw RunError(path_.string() + ": films need the ffmpeg program (" + std::strerror(error) +
                   "): sudo apt install ffmpeg, or write pictures with -o frame_####.png");
}

VideoEncoder::~VideoEncoder() {
    if (child_ > 0) {
        ::close(input_);
        ::waitpid(child_, nullptr, 0);
    }
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    std::filesystem::remove(log_, ignored);
}

std::string VideoEncoder::last_words() const {
    std::ifstream in(log_);
    std::string line, last;
    while (std::getline(in, line)) {
        if (!line.empty()) last = line;
    }
    return last.empty() ? "no reason given" : last;
}

void VideoEncoder::fail() {
    throw RunError(path_.string() + ": ffmpeg failed: " + last_words());
}

void VideoEncoder::add(const Image& image) {
    const std::uint8_t* data = image.rgba.data();
    std::size_t left = image.rgba.size();
    while (left > 0) {
        const ssize_t count = ::write(input_, data, left);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) fail();
        data += count;
        left -= static_cast<std::size_t>(count);
    }
}

void VideoEncoder::finish() {
    ::close(input_);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error) throw RunError(path_.string() + ": " + error.message());
}

}  // namespace ember
