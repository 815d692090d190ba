#pragma once

#include <cstddef>
#include <string>

namespace maquette::sim {

/// The SHA-1 of bytes as 40 lower-case hexadecimal digits.
std::string sha1_of(const void* bytes, std::size_t count);

}  // namespace maquette::sim
