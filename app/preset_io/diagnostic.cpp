#include <algorithm>
#include <fstream>

#include "app/preset_io/nearest_word.h"
#include "app/preset_io/png_text.h"
#include "app/preset_io/preset_io.h"

namespace ember {

std::string Diagnostic::text() const {
    std::string out = file;
    if (line > 0) out += ':' + std::to_string(line) + ':' + std::to_string(column);
    out += severity == Severity::Error ? ": error: " : ": warning: ";
    if (!key.empty()) out += key + ": ";
    return out + message;
}

std::string Diagnostic::excerpt() const {
    if (line <= 0 || is_png(file)) return {};
    std::ifstream in(file);
    std::string source;
    for (int number = 0; number < line; ++number) {
        if (!std::getline(in, source)) return {};
    }
    // columns count characters, not bytes; the caret must pass the tabs that the line has
    std::string caret;
    int characters = 0;
    for (const char c : source) {
        if ((static_cast<unsigned char>(c) & 0xC0u) == 0x80u) continue;
        if (++characters >= column) break;
        caret += c == '\t' ? '\t' : ' ';
    }
    return "    " + source + "\n    " + caret + '^';
}

bool PresetResult::ok() const {
    return std::none_of(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& d) {
        return d.severity == Diagnostic::Severity::Error;
    });
}

std::string nearest_key(std::string_view key, std::span<const ParamBinding> bindings) {
    const std::string_view name = key.substr(key.rfind('.') + 1);
    std::vector<std::string_view> keys;
    for (const ParamBinding& binding : bindings) {
        for (const ParamInfo& row : binding.rows) {
            // the right name in the wrong group is the likeliest slip of all
            if (row.name() == name && row.key != key) return std::string(row.key);
            keys.push_back(row.key);
        }
    }
    return nearest_word(key, keys);
}

}  // namespace ember
