#include "firmware/board/elementary.hpp"
#include "firmware/board_order.hpp"
#include "firmware/conversion.hpp"
#include "firmware/layout.hpp"

/// Where a board starts in place of board_program when its scene has something to convert.
namespace maquette::firmware {

/// The host puts the conversion behind the task.
struct ConvertingTask {
  BoardTask<BoardNumber> task;
  Conversion<BoardNumber> conversion;
};

static_assert(sizeof(ConvertingTask) ==
              board_bytes<BoardTask<float>>() + board_bytes<Conversion<float>>());

extern "C" void board_program(BoardTask<BoardNumber>& task);

extern "C" void converting_program(ConvertingTask& task) {
  convert(task.task.frame.database, task.conversion);
  board_program(task.task);
}

}  // namespace maquette::firmware
