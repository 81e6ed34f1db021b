// A small reader of binary PLY files, independent of the writer.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ember {

struct Ply {
    std::vector<std::string> declared;  ///< "double x", ... in order
    std::map<std::string, std::vector<double>> vertex;
    std::vector<std::vector<int>> faces;
};

template <class T>
T take(const std::string& bytes, std::size_t& at) {
    T value;
    if (at + sizeof value > bytes.size()) throw std::runtime_error("PLY is too short");
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

inline double take_number(const std::string& type, const std::string& bytes, std::size_t& at) {
    if (type == "double") return take<double>(bytes, at);
    if (type == "float") return static_cast<double>(take<float>(bytes, at));
    if (type == "int") return take<std::int32_t>(bytes, at);
    if (type == "uchar") return take<std::uint8_t>(bytes, at);
    throw std::runtime_error("unexpected type " + type);
}

inline Ply read_ply(const std::string& bytes) {
    Ply ply;
    const std::string end = "end_header\n";
    std::size_t at = bytes.find(end) + end.size();
    std::istringstream header(bytes.substr(0, at));
    std::string line, element;
    std::size_t vertices = 0, faces = 0;
    if (!std::getline(header, line) || line != "ply") throw std::runtime_error("no PLY");
    if (!std::getline(header, line) || line != "format binary_little_endian 1.0") {
        throw std::runtime_error("not binary little-endian");
    }
    while (std::getline(header, line)) {
        std::istringstream words(line);
        std::string first, second;
        words >> first >> second;
        if (first == "element") words >> (second == "vertex" ? vertices : faces), element = second;
        if (first == "property" && element == "vertex") ply.declared.push_back(line.substr(9));
        if (first == "property" && element == "face" &&
            line != "property list uchar int vertex_indices") {
            throw std::runtime_error("unexpected face property");
        }
    }
    for (std::size_t v = 0; v < vertices; ++v) {
        for (const std::string& property : ply.declared) {
            const std::size_t space = property.find(' ');
            ply.vertex[property.substr(space + 1)].push_back(
                take_number(property.substr(0, space), bytes, at));
        }
    }
    for (std::size_t f = 0; f < faces; ++f) {
        std::vector<int> face(take<std::uint8_t>(bytes, at));
        for (int& corner : face)
            corner = take<std::int32_t>(bytes, at);
        ply.faces.push_back(face);
    }
    if (at != bytes.size()) throw std::runtime_error("bytes are left over");
    return ply;
}

}  // namespace ember
