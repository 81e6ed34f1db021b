// The command line, one word per line: parsed, not run.
#include <CLI/CLI.hpp>
#include <sstream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> words;
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    for (std::string word; words.size() < 32 && std::getline(in, word);)
        words.push_back(word);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    CLI::App app("fuzz", "emberleaf");
    ember::Task task;
    ember::build_command_line(app, task);
    try {
        app.parse(words);
        ember::promise(task != nullptr);
    } catch (const CLI::Success&) {
        ember::promise(!app.help().empty());
    } catch (const CLI::ParseError& e) {
        ember::promise(e.get_exit_code() != 0);
    } catch (const ember::InputError&) {
    }
    return 0;
}
