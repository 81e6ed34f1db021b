#include "app/checkpoint_format.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <concepts>
#include <stdexcept>
#include <type_traits>

namespace ember {
namespace {

// A field that is added to the state needs another number: see tests/app/states/README.md.
constexpr int kFormat = 2;
constexpr std::string_view kMagic("emberleaf state ");

[[noreturn]] void refuse(const std::string& reason) {
    throw std::runtime_error(reason);
}

// Bytes of one element of an array.
template <class T>
constexpr std::size_t kBytes = sizeof(T);

struct FieldWriter {
    std::string bytes;

    template <class T>
    void operator()(const char*, const T& value) {
        put(value);
    }

    template <std::integral T>
    void put(T value) {
        const auto bits = static_cast<std::make_unsigned_t<T>>(value);
        std::array<char, sizeof bits> little{};
        for (std::size_t i = 0; i < little.size(); ++i)
            little[i] = static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xFFu);
        bytes.append(little.data(), little.size());
    }
    void put(double value) { put(std::bit_cast<std::uint64_t>(value)); }
    void put(Phase value) { put(static_cast<std::uint8_t>(value)); }
    void put(const Quad& quad) {
        for (const Index node : quad)
            put(node);
    }
    void put(const std::string& text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes += text;
    }
    template <class T>
    void put(const std::vector<T>& array) {
        put(static_cast<std::uint64_t>(array.size()));
        bytes.reserve(bytes.size() + array.size() * kBytes<T>);
        for (const T& value : array)
            put(value);
    }
};

struct FieldReader {
    std::string_view rest;

    template <class T>
    void operator()(const char*, T& value) {
        get(value);
    }
    [[nodiscard]] std::string_view take(std::uint64_t count) {
        if (count > rest.size()) refuse("the file is not whole");
        const std::string_view taken = rest.substr(0, count);
        rest.remove_prefix(count);
        return taken;
    }

    template <std::integral T>
    void get(T& value) {
        std::uint64_t bits = 0;
        const std::string_view little = take(sizeof value);
        for (std::size_t i = 0; i < little.size(); ++i)
            bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(little[i])) << (8 * i);
        value = static_cast<T>(static_cast<std::make_unsigned_t<T>>(bits));
    }
    void get(double& value) {
        std::uint64_t bits = 0;
        get(bits);
        value = std::bit_cast<double>(bits);
    }
    void get(Phase& value) {
        std::uint8_t number = 0;
        get(number);
        if (number > static_cast<std::uint8_t>(Phase::BurntOut)) refuse("damaged: no such phase");
        value = static_cast<Phase>(number);
    }
    void get(Quad& quad) {
        for (Index& node : quad)
            get(node);
    }
    void get(std::string& text) {
        std::uint64_t size = 0;
        get(size);
        text = take(size);
    }
    template <class T>
    void get(std::vector<T>& array) {
        std::uint64_t size = 0;
        get(size);
        if (size > rest.size() / kBytes<T>) refuse("the file is not whole");
        array.resize(size);
        for (T& value : array)
            get(value);
    }
};

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_section(std::string& file, std::string_view letters, const FieldWriter& contents) {
    FieldWriter section{std::string(letters)};
    section.put(static_cast<std::uint64_t>(contents.bytes.size()));
    section.bytes += contents.bytes;
    section.put(checksum(section.bytes));
    file += section.bytes;
}

// The contents of the section that comes next in `file`.
FieldReader next_section(FieldReader& file, std::string_view letters) {
    const std::string_view whole = file.rest;
    const bool expected = file.take(letters.size()) == letters;
    std::uint64_t size = 0;
    file.get(size);
    const FieldReader contents{file.take(size)};
    const std::string_view summed = whole.substr(0, whole.size() - file.rest.size());
    std::uint32_t sum = 0;
    file.get(sum);
    if (!expected || sum != checksum(summed))
        refuse("damaged: the checksum of section " + std::string(letters) + " is another");
    return contents;
}

void close(const FieldReader& section) {
    if (!section.rest.empty()) refuse("damaged: a section is longer than what it holds");
}

// What is outside the sheets, the fire and the ledgers.
template <class State, class Visitor>
void for_each_clock_field(State& state, Visitor& visit) {
    visit("tick", state.tick), visit("time", state.time), visit("refinement", state.refinement);
    visit("energy.change_curvature", state.energy.change_curvature);
}

int format_of(FieldReader& file) {
    if (!file.rest.starts_with(kMagic)) refuse("not a saved simulation");
    const std::size_t end = file.rest.find('\n');
    const std::string_view number = file.rest.substr(kMagic.size(), end - kMagic.size());
    if (number.empty() || number.size() > 4 ||
        number.find_first_not_of("0123456789") != std::string_view::npos)
        refuse("not a saved simulation");
    file.rest.remove_prefix(end + 1);
    return std::stoi(std::string(number));
}

}  // namespace

std::string saved_bytes(const std::string& program, std::uint64_t parameters,
                        const WorldState& state) {
    std::string file = std::string(kMagic) + std::to_string(kFormat) + '\n';
    FieldWriter head;
    head.put(program), head.put(parameters), head.put(hash_of(state));
    for_each_clock_field(state, head);
    head.put(static_cast<std::uint64_t>(state.sheets.size()));
    append_section(file, "HEAD", head);
    for (const SheetState& sheet : state.sheets) {
        FieldWriter out;
        out.put(static_cast<std::uint8_t>(!sheet.cracks.due.empty()));
        out.put(static_cast<std::uint8_t>(!sheet.rest_curvature.main.empty()));
        for_each_sheet_field(sheet, out);
        append_section(file, "SHEE", out);
    }
    FieldWriter fire, ledgers;
    for_each_array(const_cast<FireState&>(state.fire), [&](const auto& array) { fire.put(array); });
    append_section(file, "FIRE", fire);
    for_each_ledger_field(state, ledgers);
    append_section(file, "LEDG", ledgers);
    return file;
}

SavedState read_saved_bytes(std::string_view bytes) {
    FieldReader file{bytes};
    if (const int format = format_of(file); format != kFormat) {
        refuse("saved in format " + std::to_string(format) + "; this program reads format " +
               std::to_string(kFormat));
    }
    SavedState saved;
    std::uint64_t hash = 0, sheets = 0;
    FieldReader head = next_section(file, "HEAD");
    head.get(saved.program), head.get(saved.parameters), head.get(hash);
    for_each_clock_field(saved.state, head);
    head.get(sheets), close(head);
    for (std::uint64_t s = 0; s < sheets; ++s) {
        FieldReader in = next_section(file, "SHEE");
        std::uint8_t cracks = 0, curvature = 0;
        in.get(cracks), in.get(curvature);
        SheetState& sheet = saved.state.sheets.emplace_back();
        // the list of fields leaves these out where they are empty
        if (cracks != 0) sheet.cracks.due.resize(1);
        if (curvature != 0) sheet.rest_curvature.main.resize(1);
        for_each_sheet_field(sheet, in);
        close(in);
    }
    FieldReader fire = next_section(file, "FIRE");
    for_each_array(saved.state.fire, [&](auto& array) { fire.get(array); });
    close(fire);
    FieldReader ledgers = next_section(file, "LEDG");
    for_each_ledger_field(saved.state, ledgers);
    close(ledgers);
    if (!file.rest.empty()) refuse("damaged: there is more after its end");
    if (hash_of(saved.state) != hash) refuse("damaged: the hash of the state is another");
    return saved;
}

}  // namespace ember
