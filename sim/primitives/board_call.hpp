#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "firmware/board_functions.hpp"

/// Names of functions of a board's program, which are looked up when this program is built: a name
/// that the board's program has not does not compile.
namespace maquette::sim {

/// Whether `name` is a function, or where it ends with a colon a namespace, that has `function`.
constexpr bool holds(std::string_view name, std::string_view function) {
  const bool is_namespace = name.back() == ':';
  return is_namespace ? function.substr(0, name.size()) == name : function == name;
}

/// Whether a function stands in a namespace, which is given without colons.
constexpr bool is_in_namespace(std::string_view function, std::string_view name) {
  return function.substr(0, name.size()) == name && function.substr(name.size(), 2) == "::";
}

/// Whether the board's program has what is named: a function, or functions of a namespace.
constexpr bool has_code(std::string_view name) {
  for (const firmware::BoardFunction& function : firmware::k_board_functions) {
    if (holds(name, function.name)) {
      return true;
    }
  }
  return false;
}

/// Whether the board's program has functions in a namespace.
constexpr bool has_namespace(std::string_view name) {
  for (const firmware::BoardFunction& function : firmware::k_board_functions) {
    if (is_in_namespace(function.name, name)) {
      return true;
    }
  }
  return false;
}

/// A function, or all functions of a namespace, e.g. `real_roots::`.
struct CodeName {
  std::string_view name;

  /// To be evaluated while compiling.
  constexpr CodeName(const char* text) : name(text) {
    if (!has_code(name)) {
      throw std::invalid_argument("the program of a board has no such function");
    }
  }
};

/// The function of the board's program with this name; to be evaluated while compiling.
constexpr const firmware::BoardFunction* board_function(std::string_view name) {
  for (const firmware::BoardFunction& function : firmware::k_board_functions) {
    if (function.name == name) {
      return &function;
    }
  }
  throw std::invalid_argument("the program of a board has no such function");
}

/// A function on a chain of calls and how often it may stand there.
struct Call {
  const firmware::BoardFunction* function;
  int times;

  /// To be evaluated while compiling.
  constexpr Call(std::string_view name, int count = 1)
      : function(board_function(name)), times(count) {}
};

/// What stands in an array of its own; none when empty.
template <class Item>
struct ItemList {
  const Item* first = nullptr;
  std::size_t count = 0;

  constexpr ItemList() = default;
  template <std::size_t size>
  constexpr ItemList(const Item (&items)[size]) : first(items), count(size) {}

  [[nodiscard]] const Item* begin() const { return first; }
  [[nodiscard]] const Item* end() const { return first + count; }
};

using CodeList = ItemList<CodeName>;
/// Outermost call first.
using CallChain = ItemList<Call>;

}  // namespace maquette::sim
