// Pictures as bytes on standard output, for other programs.
#pragma once

#include "app/picture_sink.h"

namespace ember {

/// Writes red, green, blue, alpha (8 bits each, straight alpha), row by row from the top, picture
/// after picture.
class RawSink final : public PictureSink {
  public:
    void put(const Picture& picture) override;
    void finish() override {}
    [[nodiscard]] std::string where() const override;

  private:
    long count_ = 0;
};

/// Writes all of it to a file descriptor; returns 0, or errno.
[[nodiscard]] int write_bytes(int file, const std::uint8_t* bytes, std::size_t count);

}  // namespace ember
