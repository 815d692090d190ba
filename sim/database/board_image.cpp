#include "sim/database/board_image.hpp"

#include <algorithm>
#include <stdexcept>

#include "firmware/layout.hpp"
#include "sim/database/board_code.hpp"

namespace maquette::sim {

namespace {

using firmware::board_bytes;

/// Gives out addresses, one behind the other.
class Allocator {
 public:
  explicit Allocator(std::uint32_t first) : next_(first) {}

  template <class Structure>
  std::uint32_t take(std::size_t count = 1) {
    const std::uint32_t address = next_;
    next_ +=
        static_cast<std::uint32_t>(count) * static_cast<std::uint32_t>(board_bytes<Structure>());
    next_ += next_ % 2;
    return address;
  }

  [[nodiscard]] std::uint32_t next() const { return next_; }

 private:
  std::uint32_t next_;
};

/// Where the arrays of a scene are.
class Arrays {
 public:
  Arrays(std::uint32_t first, BoardWriter& writer) : allocator_(first), writer_(writer) {}

  /// Takes room for an array that the program fills, or that is written later.
  template <class Structure>
  std::uint32_t reserve(const Structure* first, std::size_t count) {
    const std::uint32_t address = allocator_.take<Structure>(count);
    writer_.tell(first, address);
    return address;
  }

  /// Takes room for an array and writes it.
  template <class Structure>
  std::uint32_t place(const Structure* first, std::size_t count) {
    const std::uint32_t address = reserve(first, count);
    writer_.write(address, first, count);
    return address;
  }

  [[nodiscard]] std::uint32_t end() const { return allocator_.next(); }

 private:
  Allocator allocator_;
  BoardWriter& writer_;
};

/// The firmware's structures, but for the task. What preprocessing and synthesis write comes last,
/// so that what is loaded is in one piece.
void place_scene(const firmware::Database<float>& database, Arrays& arrays) {
  arrays.place(database.leaves, database.leaf_count);
  arrays.place(database.composites, database.composite_count);
  arrays.place(database.parameters, database.parameter_count);
  arrays.place(database.surfaces, database.surface_count);
  arrays.place(database.lights, database.light_count);
}

void reserve_prepared(const firmware::Frame<float>& frame, Arrays& arrays) {
  const firmware::Database<float>& database = frame.database;
  arrays.reserve(frame.prepared.leaves, database.leaf_count);
  arrays.reserve(frame.prepared.extents, database.node_count());
  arrays.reserve(frame.prepared.surfaces, database.surface_count);
  arrays.reserve(frame.prepared.light_positions, database.light_count);
}

/// The program that a scene needs. Where the package in it stands for a larger one, it has as much
/// room as that.
LinkedProgram program_for(const firmware::Needs& needs, firmware::NumberFormat numbers,
                          const BoardRoom& room) {
  LinkedProgram program = linked_program(
      program_code(numbers), room.system_bytes,
      [&needs](const firmware::CodePiece& piece) { return is_needed(piece.name, needs); });
  const std::size_t least = program.package - program.base + room.package_bytes;
  program.bytes.resize(std::max(program.bytes.size(), least));
  return program;
}

std::vector<unsigned char> ram_with(const LinkedProgram& program, std::uint32_t ram_bytes) {
  if (program.base + program.bytes.size() > ram_bytes) {
    throw std::out_of_range("the program does not fit into the board's RAM");
  }
  std::vector<unsigned char> ram(ram_bytes);
  std::copy(program.bytes.begin(), program.bytes.end(), ram.begin() + program.base);
  return ram;
}

/// Puts the argument of the program above a return address that it never uses.
std::uint32_t prepare_stack(std::uint32_t task, std::vector<unsigned char>& ram) {
  constexpr std::uint32_t k_long_bytes = 4;
  const auto top = static_cast<std::uint32_t>(ram.size()) - k_long_bytes;
  for (std::uint32_t byte = 0; byte < k_long_bytes; ++byte) {
    ram[top + byte] = static_cast<unsigned char>(task >> 8 * (k_long_bytes - 1 - byte));
  }
  return top - k_long_bytes;
}

}  // namespace

BoardImage board_image(firmware::NumberFormat numbers, const firmware::Frame<float>& frame,
                       const firmware::WorkArea<float>& area, const firmware::BoardOrder& order,
                       const BoardRoom& room) {
  BoardImage image{};
  image.program = program_for(frame.database.needs, numbers, room);
  image.ram = ram_with(image.program, room.ram_bytes);
  image.database = room.system_bytes + static_cast<std::uint32_t>(image.program.bytes.size());
  image.database += image.database % 2;
  BoardWriter writer(image.ram, numbers);
  Arrays arrays(image.database, writer);
  place_scene(frame.database, arrays);
  const std::uint32_t task = arrays.reserve<firmware::BoardTask<float>>(nullptr, 1);
  image.loaded_end = arrays.end();
  reserve_prepared(frame, arrays);
  arrays.reserve(area.crossings, room.crossings);
  arrays.reserve(area.rays, room.waiting_rays);
  firmware::BoardTask<float> filled{frame, area, order};
  if (room.line_pixels > 0) {
    filled.order.line = arrays.reserve<std::uint32_t>(nullptr, room.line_pixels);
  }
  writer.write(task, &filled, 1);
  if (arrays.end() + room.stack_bytes > room.ram_bytes) {
    throw std::out_of_range("program, scene and work area do not fit into the board's RAM");
  }
  image.stack = prepare_stack(task, image.ram);
  return image;
}

}  // namespace maquette::sim
