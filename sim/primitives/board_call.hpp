#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "firmware/board_code_ffp.hpp"

/// Names of functions of a board's program, which are looked up when this program is built: a name
/// that the program with FFP numbers has not does not compile.
namespace maquette::sim {

/// Whether a function stands in a namespace, which is given without colons.
constexpr bool is_in_namespace(std::string_view function, std::string_view name) {
  return function.substr(0, name.size()) == name && function.substr(name.size(), 2) == "::";
}

/// Whether the board's program has a function or a table of this name.
constexpr bool has_code(std::string_view name) {
  for (const firmware::CodePiece& piece : firmware::board_code_ffp::k_pieces) {
    if (name == piece.name) {
      return true;
    }
  }
  return false;
}

/// Whether the board's program has functions in a namespace.
constexpr bool has_namespace(std::string_view name) {
  for (const firmware::CodePiece& piece : firmware::board_code_ffp::k_pieces) {
    if (is_in_namespace(piece.name, name)) {
      return true;
    }
  }
  return false;
}

/// A function of the board's program, all its instances.
struct CodeName {
  std::string_view name;

  /// To be evaluated while compiling.
  constexpr CodeName(const char* text) : name(text) {
    if (!has_code(name)) {
      throw std::invalid_argument("the program of a board has no such function");
    }
  }
};

/// A function that calls itself, and how often it may stand on the stack at once.
struct Recursion {
  CodeName function;
  int depth;
};

/// What stands in an array of its own; none when empty.
struct RecursionList {
  const Recursion* first = nullptr;
  std::size_t count = 0;

  constexpr RecursionList() = default;
  template <std::size_t size>
  constexpr RecursionList(const Recursion (&items)[size]) : first(items), count(size) {}

  [[nodiscard]] const Recursion* begin() const { return first; }
  [[nodiscard]] const Recursion* end() const { return first + count; }
};

}  // namespace maquette::sim
