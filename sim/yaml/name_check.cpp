#include "sim/yaml/name_check.hpp"

#include <algorithm>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_longest_name = 200;

/// Bytes from 0x80 on belong to letters beyond ASCII.
bool may_stand_in_name(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_' || letter == '-' ||
         static_cast<unsigned char>(letter) >= 0x80;
}

}  // namespace

void check_name(const std::string& name, const YamlPlace& place, std::string_view what) {
  if (name.empty() || name.size() > k_longest_name ||
      !std::all_of(name.begin(), name.end(), may_stand_in_name)) {
    throw DescriptionError(place.position(),
                           std::string{what} + ": `" + name.substr(0, k_longest_name) +
                               "` is no name; letters, digits, _ and - are allowed, up to 200");
  }
}

}  // namespace maquette::sim
