#include "sim/fields/key_table.hpp"

namespace maquette::sim {

std::string key_list(const std::vector<KeyRow>& rows) {
  constexpr std::size_t k_longest_default = 40;
  std::string text;
  for (const KeyRow& row : rows) {
    text += "  " + row.path + "\n      " + row.sentence + "\n";
    if (!row.type.empty()) {
      text += "      allowed: " + row.type + "\n";
    }
    if (row.required) {
      text += "      needed\n";
    } else if (!row.default_value.empty() && row.default_value.size() <= k_longest_default) {
      text += "      default: " + row.default_value + "\n";
    }
  }
  return text.empty() ? "  no keys\n" : text;
}

}  // namespace maquette::sim
