#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/arithmetic/number_format.hpp"

/// The program of a board as code for the 68000, in pieces that are linked for each scene.
namespace maquette::firmware {

/// A function or a table: its words, the long words in them that are addresses, and what a function
/// in C++ puts on the stack, without its return address.
struct CodePiece {
  const char* name;
  std::uint32_t first_word;
  std::uint32_t words;
  std::uint32_t first_address;
  std::uint32_t addresses;
  std::uint32_t stack_bytes;
};

/// Instead of a piece, the arithmetic package.
inline constexpr std::uint32_t k_package = 0xFFFFFFFF;

/// The long word at an offset in a piece is an address: of a byte of another piece.
struct CodeAddress {
  std::uint32_t offset;
  std::uint32_t piece;
  std::uint32_t addend;
};

/// Rows that stand in a constant array.
template <class Row>
struct CodeRows {
  const Row* first;
  std::size_t count;

  template <std::size_t size>
  constexpr CodeRows(const Row (&rows)[size])  // NOLINT(google-explicit-constructor)
      : first(rows), count(size) {}

  [[nodiscard]] constexpr const Row* begin() const { return first; }
  [[nodiscard]] constexpr const Row* end() const { return first + count; }
  [[nodiscard]] constexpr std::size_t size() const { return count; }
  constexpr const Row& operator[](std::size_t index) const { return first[index]; }
};

/// An arithmetic package, and where in it the routines begin that a program calls.
struct ArithmeticPackage {
  CodeRows<std::uint8_t> bytes;
  std::uint32_t add;
  std::uint32_t subtract;
  std::uint32_t multiply;
  std::uint32_t divide;
  std::uint32_t compare;
  std::uint32_t square_root;
  std::uint32_t to_integer;
  std::uint32_t from_integer;
};

/// A program with numbers of one format.
struct ProgramCode {
  NumberFormat numbers;
  CodeRows<CodePiece> pieces;
  CodeRows<CodeAddress> addresses;
  CodeRows<std::uint16_t> words;
  ArithmeticPackage package;
};

}  // namespace maquette::firmware
