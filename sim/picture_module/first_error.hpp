#pragma once

#include <string>

namespace maquette::sim {

/// What OpenImageIO says is wrong with a file: the first of its lines.
template <typename File>
std::string first_error(File& file) {
  const std::string errors = file.geterror();
  return errors.empty() ? "of an unknown error" : errors.substr(0, errors.find('\n'));
}

}  // namespace maquette::sim
