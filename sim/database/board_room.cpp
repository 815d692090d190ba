#include "sim/database/board_room.hpp"

#include "models/board/pixel_store.hpp"

namespace maquette::sim {

BoardRoom board_room(const Machine& machine, std::uint32_t shared_database) {
  const models::Kvm02Parameters& board = machine.parameters.board;
  BoardRoom room{};
  room.ram_bytes = static_cast<std::uint32_t>(board.ram_bytes);
  room.system_bytes = static_cast<std::uint32_t>(machine.system_bytes);
  room.crossings = static_cast<std::uint32_t>(machine.crossing_capacity);
  room.waiting_rays = static_cast<std::uint32_t>(machine.ray_capacity);
  room.stack_bytes = static_cast<std::uint32_t>(machine.stack_bytes);
  room.package_bytes = static_cast<std::uint32_t>(board.arithmetic.package_bytes);
  if (models::keeps_line(board.pixel_write)) {
    room.line_pixels = static_cast<std::uint32_t>(machine.parameters.frame_memory.width);
  }
  if (models::is_shared(board.database)) {
    room.shared_database = shared_database;
  }
  if (models::is_distributed(machine.parameters.frame_memory)) {
    room.own_pixel_bytes = static_cast<std::uint32_t>(models::PixelStore{
        models::interlace_of(machine.parameters.allotment,
                             static_cast<int>(machine.parameters.boards.size())),
        machine.parameters.frame_memory.width, machine.parameters.frame_memory.height}
                                                          .bytes());
  }
  if (models::has_units(machine.parameters.units)) {
    room.pixels_in_flight = static_cast<std::uint32_t>(machine.parameters.units.in_flight);
  }
  room.order = machine.parameters.allotment.order;
  return room;
}

}  // namespace maquette::sim
