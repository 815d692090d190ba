#include "firmware/board/claim.hpp"
#include "firmware/board/elementary.hpp"
#include "firmware/board/pixel_output.hpp"
#include "firmware/board/unit_synthesis.hpp"
#include "firmware/board/units.hpp"
#include "firmware/layout.hpp"
#include "firmware/preprocess.hpp"

/// The program of a board: the firmware in the board's own number format, compiled freestanding for
/// the 68000, and the loop over the pixels of its share.
namespace maquette::firmware {

static_assert(sizeof(BoardTask<BoardNumber>) == board_bytes<BoardTask<float>>());
static_assert(sizeof(Leaf<BoardNumber>) == board_bytes<Leaf<float>>());
static_assert(sizeof(Composite) == board_bytes<Composite>());
static_assert(sizeof(Surface<BoardNumber>) == board_bytes<Surface<float>>());
static_assert(sizeof(Light<BoardNumber>) == board_bytes<Light<float>>());
static_assert(sizeof(LightShape<BoardNumber>) == board_bytes<LightShape<float>>());
static_assert(sizeof(Texture<BoardNumber>) == board_bytes<Texture<float>>());
static_assert(sizeof(PreparedLeaf<BoardNumber>) == board_bytes<PreparedLeaf<float>>());
static_assert(sizeof(Extent<BoardNumber>) == board_bytes<Extent<float>>());
static_assert(sizeof(PreparedSurface<BoardNumber>) == board_bytes<PreparedSurface<float>>());
static_assert(sizeof(Crossing<BoardNumber>) == board_bytes<Crossing<float>>());
static_assert(sizeof(PendingRay<BoardNumber>) == board_bytes<PendingRay<float>>());

void synthesize_unit(const BoardTask<BoardNumber>& task, const Rectangle& unit, Line& line) {
  for (std::int16_t row = unit.first_row; row < unit.end_row; ++row) {
    if (line.count != 0 && line.row != row) {
      flush(task.order, line);
    }
    for (std::int16_t column = unit.first_column; column < unit.end_column; ++column) {
      put(task.order, line, column, row,
          synthesize<Projection::perspective>(task.frame, task.area, column, row));
    }
  }
}

/// A routine of its own, so that a simulator can tell where preprocessing ends.
extern "C" [[gnu::noinline]] void board_synthesis(const BoardTask<BoardNumber>& task) {
  const BoardOrder& order = task.order;
  const Rectangle& zone = task.frame.prepared.useful_zone;
  const bool claims = order.lock != 0;
  const bool single = order.bands == 0 && order.unit_width == 1 && order.unit_height == 1;
  Line line{0, 0, 0, static_cast<std::int16_t>(single && !claims ? order.unit_step : 1)};
  if (zone.is_empty()) {
    return;
  }
  const std::uint32_t count = units::count(order, zone);
  std::uint32_t unit = claims ? claimed_unit(order.lock, order.unit_step) : order.first_unit;
  while (unit < count) {
    synthesize_unit(task, units::pixels(order, zone, unit), line);
    if (claims) {
      flush(order, line);
      unit = claimed_unit(order.lock, order.unit_step);
    } else {
      unit += order.unit_step;
    }
  }
  flush(order, line);
}

/// Where a board starts, its task on the stack. It stops when its share is done.
extern "C" void board_program(BoardTask<BoardNumber>& task) {
  preprocess(task.frame.database, task.frame.prepared);
  board_synthesis(task);
  __asm__ volatile("stop #0x2700");
}

}  // namespace maquette::firmware
