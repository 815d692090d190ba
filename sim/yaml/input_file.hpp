#pragma once

#include <cstddef>
#include <string>

namespace maquette::sim {

/// Bytes that a file of input may have.
inline constexpr std::size_t k_most_input_bytes = 64U << 20U;

/// A file with what was read of it: what is read once may be a pipe.
struct InputFile {
  std::string path;     ///< as the user gave it
  std::string content;  ///< its bytes
};

/// Reads a file, pipe or device to its end. Throws DescriptionError when it cannot be read, is a
/// directory or goes on beyond k_most_input_bytes.
[[nodiscard]] InputFile read_input(const std::string& path);

}  // namespace maquette::sim
