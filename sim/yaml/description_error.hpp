#pragma once

#include <stdexcept>
#include <string>

#include "sim/yaml/source_position.hpp"

namespace maquette::sim {

/// What a user wrote is wrong: `file:line:column: what is wrong, what is allowed`. The program
/// prints it, writes nothing and exits with code 2.
class DescriptionError : public std::runtime_error {
 public:
  DescriptionError(const SourcePosition& position, const std::string& message)
      : std::runtime_error(position.file + ":" + std::to_string(position.line) + ":" +
                           std::to_string(position.column) + ": " + message) {}

  /// For errors that belong to no place in a file, such as an unwritable directory.
  explicit DescriptionError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace maquette::sim
