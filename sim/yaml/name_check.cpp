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

bool may_stand_in_file_name(char letter) {
  constexpr std::string_view k_signs = " .+(),=";
  return may_stand_in_name(letter) || k_signs.find(letter) != std::string_view::npos;
}

/// The beginning of a name, with control characters as question marks.
std::string shown(const std::string& name) {
  std::string text = name.substr(0, k_longest_name);
  std::replace_if(
      text.begin(), text.end(),
      [](char letter) { return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f'; },
      '?');
  return text;
}

}  // namespace

void check_name(const std::string& name, const YamlPlace& place, std::string_view what) {
  if (name.empty() || name.size() > k_longest_name ||
      !std::all_of(name.begin(), name.end(), may_stand_in_name)) {
    throw DescriptionError(place.position(),
                           std::string{what} + ": `" + shown(name) +
                               "` is no name; letters, digits, _ and - are allowed, up to 200");
  }
}

bool is_file_name(const std::string& name) {
  return !name.empty() && name.size() <= k_longest_name && name.front() != '.' &&
         name.front() != '-' && std::all_of(name.begin(), name.end(), may_stand_in_file_name);
}

void check_file_name(const std::string& name, const YamlPlace& place, std::string_view what) {
  if (!is_file_name(name)) {
    throw DescriptionError(place.position(), std::string{what} + ": `" + shown(name) +
                                                 "` is no name of a file; " +
                                                 std::string{k_file_name_letters});
  }
}

}  // namespace maquette::sim
