// Numbers as they lie in binary files: little endian.
#pragma once

#include <bit>
#include <string>
#include <type_traits>

namespace ember {

static_assert(std::endian::native == std::endian::little, "values are copied as they lie");

/// Appends the bytes of one number, sizeof(T) of them.
template <class T>
void put(std::string& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace ember
