#include "app/raw_sink.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/exit_code.h"

namespace ember {

int write_bytes(int file, const std::uint8_t* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = ::write(file, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
    return 0;
}

void RawSink::put(const Picture& picture) {
    const int error =
        write_bytes(STDOUT_FILENO, picture.image.rgba.data(), picture.image.rgba.size());
    if (error != 0) throw RunError(std::string("standard output: ") + std::strerror(error));
    ++count_;
}

std::string RawSink::where() const {
    return std::to_string(count_) + " pictures on standard output";
}

}  // namespace ember
