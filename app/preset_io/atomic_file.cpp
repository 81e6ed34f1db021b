#include "app/preset_io/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace ember {

std::filesystem::path temporary_name(const std::filesystem::path& path) {
    // the extension stays last, because programs such as ffmpeg go by it
    return path.parent_path() / ('.' + path.stem().string() + ".tmp-" + std::to_string(::getpid()) +
                                 path.extension().string());
}

void make_folder_of(const std::filesystem::path& path) {
    if (!path.has_parent_path()) return;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (error) {
        throw std::runtime_error(path.parent_path().string() +
                                 ": cannot create: " + error.message());
    }
}

void write_file(const std::filesystem::path& path, std::string_view contents) {
    make_folder_of(path);
    const std::filesystem::path temporary = temporary_name(path);
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    bool good = file >= 0;
    while (good && !contents.empty()) {
        const ssize_t count = ::write(file, contents.data(), contents.size());
        if (count < 0 && errno == EINTR) continue;
        good = count > 0;
        if (good) contents.remove_prefix(static_cast<std::size_t>(count));
    }
    good = good && ::fsync(file) == 0;
    std::string reason = good ? "" : std::strerror(errno);
    if (file >= 0 && ::close(file) != 0 && good) {
        good = false;
        reason = std::strerror(errno);
    }
    if (good && ::rename(temporary.c_str(), path.c_str()) != 0) {
        good = false;
        reason = std::strerror(errno);
    }
    if (good) return;
    ::unlink(temporary.c_str());
    throw std::runtime_error(path.string() + ": cannot write: " + reason);
}

}  // namespace ember
