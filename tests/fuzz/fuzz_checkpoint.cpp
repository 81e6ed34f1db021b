// A saved simulation: as it is, and again with its checksums put right, since no chance finds
// those.
#include <zlib.h>

#include <cstring>
#include <stdexcept>

#include "app/checkpoint_format.h"
#include "promise.h"

namespace ember {
namespace {

// Walks the sections as far as their lengths lead.
std::string with_right_checksums(std::string bytes) {
    std::size_t at = bytes.find('\n');
    if (at == std::string::npos) return bytes;
    for (++at; at + 16 <= bytes.size();) {
        std::uint64_t length = 0;
        for (std::size_t i = 0; i < 8; ++i)
            length |= std::uint64_t{static_cast<unsigned char>(bytes[at + 4 + i])} << (8 * i);
        if (length > bytes.size() - at - 16) break;
        const auto* section = reinterpret_cast<const Bytef*>(bytes.data() + at);
        const unsigned long sum = crc32_z(0, section, length + 12);
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at + 12 + length + i] = static_cast<char>(sum >> (8 * i) & 0xFFu);
        at += 16 + length;
    }
    return bytes;
}

void read(const std::string& bytes) {
    try {
        const SavedState saved = read_saved_bytes(bytes);
        promise(saved_bytes(saved.program, saved.parameters, saved.state) == bytes);
        static_cast<void>(misfit(saved.state, saved.state));
    } catch (const std::runtime_error& e) {
        promise(std::strlen(e.what()) > 0);
    }
}

}  // namespace
}  // namespace ember

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    ember::read(bytes);
    ember::read(ember::with_right_checksums(bytes));
    return 0;
}
