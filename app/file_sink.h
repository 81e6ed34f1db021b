// Pictures as numbered files, each whole or not there.
#pragma once

#include "app/file_pattern.h"
#include "app/picture_sink.h"

namespace ember {

class FileSink : public PictureSink {
  public:
    /// Makes the folder, and removes what killed runs have left in it.
    FileSink(const std::string& output, const PictureFormat& format);

    [[nodiscard]] bool has(long number, double time) const override;
    void put(const Picture& picture) override;
    void finish() override {}
    [[nodiscard]] std::string where() const override;

  protected:
    [[nodiscard]] std::string name(long number) const { return pattern_.name(number); }

  private:
    virtual void write(const std::string& path, const Picture& picture, const ImageText& text) = 0;
    /// Reads the whole file; throws when it is not whole.
    [[nodiscard]] virtual ImageText read(const std::string& path) const = 0;
    [[nodiscard]] ImageText text_of(long number, double time) const;

    FilePattern pattern_;
    ImageText text_;
    std::string first_, last_;
    long count_ = 0;
};

class PngSink final : public FileSink {
  public:
    using FileSink::FileSink;
    [[nodiscard]] std::optional<Image> kept(long number) const override;

  private:
    void write(const std::string& path, const Picture& picture, const ImageText& text) override;
    [[nodiscard]] ImageText read(const std::string& path) const override;
};

class ExrSink final : public FileSink {
  public:
    using FileSink::FileSink;
    [[nodiscard]] bool wants_layers() const override { return true; }

  private:
    void write(const std::string& path, const Picture& picture, const ImageText& text) override;
    [[nodiscard]] ImageText read(const std::string& path) const override;
};

}  // namespace ember
