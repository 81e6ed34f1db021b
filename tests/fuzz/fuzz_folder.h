// A folder for the files that a fuzz target reads; removed when the program ends by itself.
#pragma once

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace ember {

class FuzzFolder {
  public:
    FuzzFolder() {
        std::string name = std::filesystem::temp_directory_path() / "emberleaf-fuzz-XXXXXX";
        path_ = ::mkdtemp(name.data());
    }
    ~FuzzFolder() { std::filesystem::remove_all(path_); }
    FuzzFolder(const FuzzFolder&) = delete;
    FuzzFolder& operator=(const FuzzFolder&) = delete;

    [[nodiscard]] std::filesystem::path write(const char* name, const std::uint8_t* data,
                                              std::size_t size) const {
        std::ofstream(path_ / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

/// Ends the program as a crash does: what is promised does not hold.
inline void promise(bool holds) {
    if (!holds) __builtin_trap();
}

}  // namespace ember
