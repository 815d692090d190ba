#include "firmware/board/claim.hpp"
#include "firmware/board/short_arithmetic.hpp"
#include "firmware/board/unit_synthesis.hpp"

/// What a board does in place of board_synthesis when its units are those of an interlace, which
/// are as many as there are boards: of each unit_width x unit_height pixels of the screen the one
/// of the unit's number.
namespace maquette::firmware {

namespace {

/// The first number from `begin` on that leaves this remainder.
std::int16_t first_with(std::uint16_t remainder, std::int16_t begin, std::uint16_t distance) {
  const std::uint16_t over = quotient(static_cast<std::uint16_t>(begin), distance).remainder;
  const int ahead = remainder - over + (remainder < over ? distance : 0);
  return static_cast<std::int16_t>(begin + ahead);
}

std::int16_t next(std::int16_t place) { return static_cast<std::int16_t>(place + 1); }

void synthesize_interlaced(const BoardTask<BoardNumber>& task, std::uint32_t unit, Line& line) {
  const BoardOrder& order = task.order;
  const Rectangle& zone = task.frame.prepared.useful_zone;
  const Quotient place = quotient(unit, order.unit_width);
  const std::int16_t first = first_with(place.remainder, zone.first_column, order.unit_width);
  std::int16_t row = first_with(place.value, zone.first_row, order.unit_height);
  for (; row < zone.end_row; row = static_cast<std::int16_t>(row + order.unit_height)) {
    for (std::int16_t column = first; column < zone.end_column;
         column = static_cast<std::int16_t>(column + order.unit_width)) {
      synthesize_unit(task, {column, next(column), row, next(row)}, line);
    }
  }
}

}  // namespace

extern "C" void interlaced_synthesis(const BoardTask<BoardNumber>& task) {
  const BoardOrder& order = task.order;
  const bool claims = order.lock != 0;
  Line line{0, 0, 0, static_cast<std::int16_t>(order.unit_width)};
  if (task.frame.prepared.useful_zone.is_empty()) {
    return;
  }
  std::uint32_t unit = claims ? claimed_unit(order.lock, order.unit_step) : order.first_unit;
  while (unit < order.unit_step) {
    synthesize_interlaced(task, unit, line);
    flush(order, line);
    unit = claims ? claimed_unit(order.lock, order.unit_step) : unit + order.unit_step;
  }
}

}  // namespace maquette::firmware
