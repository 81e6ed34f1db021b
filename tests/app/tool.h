// Other people's programs, as independent witnesses.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace ember {

struct ToolResult {
    int status = -1;  ///< as the shell tells it
    std::string out;  ///< with what it said on standard error
};

[[nodiscard]] inline ToolResult run_tool(const std::string& command) {
    ToolResult result;
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return result;
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
        result.out.append(part.data(), count);
    result.status = ::pclose(pipe);
    return result;
}

}  // namespace ember
