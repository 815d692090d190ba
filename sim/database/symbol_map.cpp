#include "sim/database/symbol_map.hpp"

#include <fmt/format.h>

#include "sim/database/board_link.hpp"
#include "sim/database/memory_map.hpp"

namespace maquette::sim {

namespace {

std::string line_of(std::uint64_t address, std::uint64_t bytes, const std::string& name) {
  return fmt::format("{:06X} {:06X} {}\n", address, bytes, name);
}

std::string piece_lines(const BoardPieces& pieces, const LinkedProgram& program) {
  std::string text;
  for (std::size_t i = 0; i < pieces.bytes.size(); ++i) {
    if (pieces.bytes[i] > 0) {
      text += line_of(program.addresses[i], pieces.bytes[i],
                      std::string("  ") + pieces.code->pieces[i].name);
    }
  }
  return text;
}

}  // namespace

std::string symbol_map(const PackedScene<float>& scene, const Machine& machine) {
  const firmware::Database<float> database = scene.database();
  const BoardPieces pieces =
      needed_pieces(program_code(models::numbers_of(machine.parameters.board.arithmetic)),
                    database.needs, machine.parameters.allotment.order);
  const LinkedProgram program =
      linked_program(static_cast<std::uint32_t>(machine.system_bytes), pieces);
  std::string text;
  for (const MemoryUse& use : memory_map_of(scene, machine).uses) {
    text += line_of(static_cast<std::uint64_t>(use.address), static_cast<std::uint64_t>(use.bytes),
                    use.name);
    if (use.address == program.base) {
      text += piece_lines(pieces, program);
    }
  }
  return text;
}

}  // namespace maquette::sim
