#include "sim/database/board_link.hpp"

namespace maquette::sim {

namespace {

constexpr unsigned k_byte_bits = 8;
constexpr std::size_t k_word_bytes = 2;
constexpr std::uint32_t k_long_bytes = 4;

void put_word(unsigned char* place, std::uint32_t word) {
  place[0] = static_cast<unsigned char>(word >> k_byte_bits);
  place[1] = static_cast<unsigned char>(word);
}

void put_long(unsigned char* place, std::uint32_t value) {
  put_word(place, value >> 2 * k_byte_bits);
  put_word(place + k_word_bytes, value);
}

void copy_words(const firmware::ProgramCode& code, const firmware::CodePiece& piece,
                std::uint32_t bytes, unsigned char* place) {
  for (std::uint32_t i = 0; i < bytes / k_word_bytes; ++i) {
    put_word(place + k_word_bytes * i, code.words[piece.first_word + i]);
  }
}

void resolve_addresses(const firmware::CodePiece& piece, std::uint32_t bytes,
                       const BoardPieces& pieces, const LinkedProgram& program,
                       unsigned char* place) {
  for (std::uint32_t i = 0; i < piece.addresses; ++i) {
    const firmware::CodeAddress& address = program.code->addresses[piece.first_address + i];
    const std::uint32_t target = address.piece == firmware::k_package
                                     ? program.package
                                     : program.addresses[pieces.target(address.piece)];
    if (address.offset + k_long_bytes <= bytes) {
      put_long(place + address.offset, target == k_left_out ? target : target + address.addend);
    }
  }
}

}  // namespace

LinkedProgram linked_program(std::uint32_t base, const BoardPieces& pieces) {
  const firmware::ProgramCode& code = *pieces.code;
  LinkedProgram program{&code, base, 0, {}, {}};
  std::uint32_t end = base;
  for (const std::uint32_t bytes : pieces.bytes) {
    program.addresses.push_back(bytes == 0 ? k_left_out : end);
    end += bytes;
  }
  program.package = end;
  program.bytes.resize(end - base);
  program.bytes.insert(program.bytes.end(), code.package.bytes.begin(), code.package.bytes.end());
  for (std::size_t i = 0; i < program.addresses.size(); ++i) {
    if (program.addresses[i] != k_left_out) {
      unsigned char* const place = program.bytes.data() + (program.addresses[i] - base);
      copy_words(code, code.pieces[i], pieces.bytes[i], place);
      resolve_addresses(code.pieces[i], pieces.bytes[i], pieces, program, place);
    }
  }
  return program;
}

std::uint32_t beginning_of(const LinkedProgram& program) {
  const std::uint32_t converting = address_of(program, "converting_program");
  return converting != k_left_out ? converting : address_of(program, "board_program");
}

std::uint32_t address_of(const LinkedProgram& program, std::string_view name) {
  for (std::size_t i = 0; i < program.addresses.size(); ++i) {
    if (program.code->pieces[i].name == name && program.addresses[i] != k_left_out) {
      return program.addresses[i];
    }
  }
  return k_left_out;
}

}  // namespace maquette::sim
