#include "sim/database/board_image.hpp"

#include <algorithm>
#include <stdexcept>

#include "firmware/layout.hpp"
#include "sim/database/ram_layout.hpp"

namespace maquette::sim {

namespace {

constexpr std::uint32_t k_long_bytes = firmware::BoardLayout::k_long_bytes;

std::uint32_t address_of(const RamPlace& place) {
  return static_cast<std::uint32_t>(place.address);
}

void tell_places(const RamLayout& layout, BoardWriter& writer) {
  for (const RamPlace& place : layout.places) {
    writer.tell(place.object, address_of(place));
  }
}

/// Tells where arrays are that follow one another from an address on.
void tell_arrays(const firmware::Database<float>& database,
                 const firmware::Conversion<float>& conversion, std::uint32_t address,
                 BoardWriter& writer) {
  for_each_array(database, conversion, [&](const auto* first, std::size_t count) {
    writer.tell(first, address);
    address += static_cast<std::uint32_t>(static_cast<std::int64_t>(count) *
                                          firmware::board_bytes<std::decay_t<decltype(*first)>>());
  });
}

void write_arrays(const firmware::Database<float>& database,
                  const firmware::Conversion<float>& conversion, BoardWriter& writer) {
  for_each_array(database, conversion, [&writer](const auto* first, std::size_t count) {
    if (count > 0) {
      writer.write(writer.address_of(first), first, count);
    }
  });
}

/// Puts the argument of the program above a return address that it never uses.
std::uint32_t prepare_stack(std::uint32_t task, std::vector<unsigned char>& ram,
                            BoardWriter& writer) {
  const auto top = static_cast<std::uint32_t>(ram.size()) - k_long_bytes;
  writer.write(top, &task, 1);
  return top - k_long_bytes;
}

}  // namespace

BoardImage board_image(firmware::NumberFormat numbers, const PreparedScene<float>& scene,
                       const firmware::WorkArea<float>& area, const firmware::BoardOrder& order,
                       const BoardRoom& room) {
  const firmware::Frame<float>& frame = scene.frame();
  const firmware::Conversion<float>& conversion = scene.conversion();
  const BoardPieces pieces = needed_pieces(program_code(numbers), frame.database.needs, room.order);
  firmware::BoardTask<float> task{frame, area, order};
  const RamLayout layout = ram_layout(task, conversion, pieces, room);
  if (!layout.fits(room)) {
    throw std::out_of_range("program, scene and work area do not fit into the board's RAM");
  }
  BoardImage image{};
  image.program = linked_program(room.system_bytes, pieces);
  image.database = static_cast<std::uint32_t>(layout.first_loaded_data);
  image.loaded_end = static_cast<std::uint32_t>(layout.loaded_end);
  image.ram.resize(room.ram_bytes);
  std::copy(image.program.bytes.begin(), image.program.bytes.end(),
            image.ram.begin() + image.program.base);
  BoardWriter writer(image.ram, numbers);
  tell_places(layout, writer);
  if (room.shared_database) {
    tell_arrays(frame.database, conversion, *room.shared_database, writer);
  } else {
    write_arrays(frame.database, conversion, writer);
  }
  task.order.line = room.line_pixels > 0 ? writer.address_of(&task.order.line) : 0;
  image.own_pixels = room.own_pixel_bytes > 0 ? writer.address_of(&task.order.frame_memory) : 0;
  const std::uint32_t task_address = writer.address_of(&task);
  writer.write(task_address, &task, 1);
  if (conversion.given_count > 0) {
    writer.write(writer.address_of(&conversion), &conversion, 1);
  }
  image.stack = prepare_stack(task_address, image.ram, writer);
  return image;
}

std::vector<unsigned char> database_image(const PackedScene<float>& scene,
                                          firmware::NumberFormat numbers) {
  const firmware::Database<float> database = scene.database();
  const firmware::Conversion<float> conversion = scene.conversion();
  std::vector<unsigned char> bytes;
  for_each_array(database, conversion, [&bytes](const auto* first, std::size_t count) {
    using Structure = std::decay_t<decltype(*first)>;
    bytes.resize(bytes.size() +
                 count * static_cast<std::size_t>(firmware::board_bytes<Structure>()));
  });
  BoardWriter writer(bytes, numbers);
  tell_arrays(database, conversion, 0, writer);
  write_arrays(database, conversion, writer);
  return bytes;
}

}  // namespace maquette::sim
