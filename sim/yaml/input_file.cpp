#include "sim/yaml/input_file.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

InputFile read_input(const std::string& path) {
  std::error_code ignored;
  std::ifstream stream{path, std::ios::binary};
  if (!stream || std::filesystem::is_directory(path, ignored)) {
    throw DescriptionError("cannot read the file `" + path + "`");
  }
  InputFile input{path, {}};
  std::array<char, 1U << 16U> part{};
  while (stream.read(part.data(), part.size()) || stream.gcount() > 0) {
    input.content.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    if (input.content.size() > k_most_input_bytes) {
      throw DescriptionError(path + ": more than " + std::to_string(k_most_input_bytes >> 20U) +
                             " MiB; less is allowed");
    }
  }
  return input;
}

}  // namespace maquette::sim
