#pragma once

#include <string_view>

namespace maquette::sim {

/// One parameter of a description, declared once: reading, checking, writing, help and
/// documentation all come from it.
struct Declaration {
  std::string_view key;
  std::string_view sentence;     ///< what it is, for people
  std::string_view source = {};  ///< where the default figure comes from, with its mark
  bool required = false;
};

/// A parameter that has no default.
constexpr Declaration required(std::string_view key, std::string_view sentence,
                               std::string_view source = {}) {
  return {key, sentence, source, true};
}

}  // namespace maquette::sim
