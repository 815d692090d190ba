#include "sim/run/executed_pixels.hpp"

#include <stdexcept>

#include "models/board/program_time.hpp"
#include "models/display/frame_memory.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/board_start.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/execution_check.hpp"
#include "sim/run/pixel_sample.hpp"

namespace maquette::sim {

namespace {

using models::BoardProgram;
using models::ProgramEvent;
using models::mc68000::BusRequest;

firmware::BoardOrder sample_order(Machine machine, const models::PixelRectangle& zone, int share) {
  const PixelSample sample = pixel_sample(machine, zone, share);
  machine.parameters.allotment = sample.allotment;
  models::FrameSetup setup;
  setup.useful_zone = zone;
  firmware::BoardOrder order = board_order(machine, setup);
  order.unit_step = static_cast<std::uint32_t>(sample.step);
  return order;
}

/// RAM up to the frame memory: what does not fit a board has been found out before.
BoardRoom roomy(const Machine& machine, const firmware::BoardOrder& order) {
  BoardRoom room = board_room(machine);
  room.ram_bytes = order.frame_memory;
  room.line_pixels = 0;
  return room;
}

/// Follows a program from pixel to pixel.
class PixelFollower {
 public:
  PixelFollower(const Machine& machine, const firmware::BoardOrder& order, const PixelTaker& take)
      : time_(machine.parameters.board), order_(order), take_(take) {}

  /// False at the end.
  bool follow(const ProgramEvent& event) {
    const models::Duration elapsed = time_.elapsed(event.account, event.work);
    switch (event.kind) {
      case ProgramEvent::Kind::synthesis:
        last_ = elapsed;
        return true;
      case ProgramEvent::Kind::access:
        return follow_write(event.request, elapsed);
      case ProgramEvent::Kind::end:
        break;
    }
    if (event.stop.reason != models::mc68000::StopReason::stop_instruction) {
      throw std::logic_error(std::string("the program of a board stops: ") +
                             models::mc68000::name_of(event.stop.reason));
    }
    return false;
  }

 private:
  // A pixel is written when its second word is.
  bool follow_write(const BusRequest& request, models::Duration elapsed) {
    constexpr unsigned k_word_bits = 16;
    if (request.kind != BusRequest::Kind::write || request.address < order_.frame_memory) {
      throw std::logic_error("the program of a board does not only write pixels");
    }
    const std::uint32_t offset = request.address - order_.frame_memory;
    if (offset % models::FrameMemory::k_pixel_bytes == 0) {
      first_word_ = request.value;
      return true;
    }
    const std::uint32_t number = offset / models::FrameMemory::k_pixel_bytes;
    const ExecutedPixel pixel{{static_cast<int>(number % order_.frame_width),
                               static_cast<int>(number / order_.frame_width)},
                              first_word_ << k_word_bits | request.value,
                              elapsed - last_};
    last_ = elapsed;
    return take_(pixel);
  }

  models::ProgramTime time_;
  const firmware::BoardOrder& order_;
  const PixelTaker& take_;
  models::Duration last_{};
  std::uint32_t first_word_ = 0;
};

}  // namespace

void execute_pixels(const Scene& scene, const Machine& machine, int share, const PixelTaker& take) {
  require_execution(machine);
  const PreparedScene<float> prepared(packed_scene<float>(scene, picture_format_of(machine)));
  SynthesisArea<float> area(prepared.frame().database);
  const firmware::BoardOrder order = sample_order(machine, useful_zone_of(prepared.frame()), share);
  BoardImage image = board_image(models::numbers_of(machine.parameters.board.arithmetic),
                                 prepared.frame(), area.view(), order, roomy(machine, order));
  PixelFollower follower(machine, order, take);
  models::ProgramSlots slots(1);
  BoardProgram program({image.ram.data(), static_cast<std::uint32_t>(image.ram.size())},
                       program_entry(image), host_routines(machine, image), slots);
  while (follower.follow(program.next())) {
  }
}

}  // namespace maquette::sim
