#include "sim/page/assets.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace maquette::sim {

std::string_view asset(std::string_view name) {
  const auto& all = assets();
  const auto place = std::find_if(all.begin(), all.end(),
                                  [name](const Asset& asset) { return asset.name == name; });
  if (place == all.end()) {
    throw std::logic_error("the program has no file " + std::string(name));
  }
  return place->content;
}

}  // namespace maquette::sim
