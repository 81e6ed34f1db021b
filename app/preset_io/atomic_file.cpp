#include "app/preset_io/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>

namespace ember {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw std::runtime_error(path.string() + ": cannot write: " + reason);
}

// What every temporary name of this machine has in it, before the number of the process.
std::string mark() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    return ".tmp-" + std::string(host.data()) + '-';
}

bool is_running(pid_t process) {
    return ::kill(process, 0) == 0 || errno == EPERM;
}

// Writes all of it and makes it durable; says why not.
std::string write_all(const fs::path& path, std::string_view contents) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) return std::strerror(errno);
    bool good = true;
    while (good && !contents.empty()) {
        const ssize_t count = ::write(file, contents.data(), contents.size());
        if (count < 0 && errno == EINTR) continue;
        good = count > 0;
        if (good) contents.remove_prefix(static_cast<std::size_t>(count));
    }
    good = good && ::fsync(file) == 0;
    std::string reason = good ? "" : std::strerror(errno);
    if (::close(file) != 0 && good) reason = std::strerror(errno);
    return reason;
}

// A name is durable only when its folder is. Not every file system can do that, and then there is
// nothing to be done about it.
void sync_folder_of(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    static_cast<void>(::fsync(file));
    ::close(file);
}

void rename_or_remove(const fs::path& temporary, const fs::path& path) {
    if (::rename(temporary.c_str(), path.c_str()) == 0) return sync_folder_of(path);
    const std::string reason = std::strerror(errno);
    ::unlink(temporary.c_str());
    fail(path, reason);
}

}  // namespace

fs::path temporary_name(const fs::path& path) {
    // the extension stays last, because programs such as ffmpeg go by it
    return path.parent_path() / ('.' + path.stem().string() + mark() + std::to_string(::getpid()) +
                                 path.extension().string());
}

void remove_stale_temporaries(const fs::path& folder) {
    const std::string ours = mark();
    std::error_code error;
    for (const auto& entry :
         fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error)) {
        const std::string name = entry.path().filename().string();
        const std::size_t at = name.find(ours);
        if (name.front() != '.' || at == std::string::npos) continue;
        const char* digits = name.data() + at + ours.size();
        pid_t process = 0;
        const auto [end, bad] = std::from_chars(digits, name.data() + name.size(), process);
        const bool whole = bad == std::errc() && (*end == '.' || *end == '\0');
        std::error_code ignored;
        if (whole && !is_running(process)) fs::remove(entry.path(), ignored);
    }
}

void make_folder_of(const fs::path& path) {
    if (!path.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
        throw std::runtime_error(path.parent_path().string() +
                                 ": cannot create: " + error.message());
    }
}

void publish_file(const fs::path& temporary, const fs::path& path) {
    const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
    const bool durable = file >= 0 && ::fsync(file) == 0;
    const std::string reason = durable ? "" : std::strerror(errno);
    if (file >= 0) ::close(file);
    if (!durable) {
        ::unlink(temporary.c_str());
        fail(path, reason);
    }
    rename_or_remove(temporary, path);
}

void write_file(const fs::path& path, std::string_view contents) {
    make_folder_of(path);
    const fs::path temporary = temporary_name(path);
    const std::string reason = write_all(temporary, contents);
    if (!reason.empty()) {
        ::unlink(temporary.c_str());
        fail(path, reason);
    }
    rename_or_remove(temporary, path);
}

}  // namespace ember
