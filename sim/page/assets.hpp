#pragma once

#include <string_view>
#include <vector>

namespace maquette::sim {

/// A file that is part of the program: what pages have of styles and scripts.
struct Asset {
  std::string_view name;  ///< without its folder
  std::string_view content;
};

/// All of them, as assets.cmake lists them.
[[nodiscard]] const std::vector<Asset>& assets();

/// The content of one. Throws std::logic_error where there is none of that name.
[[nodiscard]] std::string_view asset(std::string_view name);

}  // namespace maquette::sim
