#include "sim/run/executed_pixels.hpp"

#include <stdexcept>

#include "models/board/program_time.hpp"
#include "models/display/frame_memory.hpp"
#include "sim/database/memory_map.hpp"
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

firmware::BoardOrder sample_order(const Machine& machine, const models::PixelRectangle& zone,
                                  int step) {
  models::FrameSetup setup;
  setup.useful_zone = zone;
  firmware::BoardOrder order = board_order(machine, setup);
  order.unit_step = static_cast<std::uint32_t>(step);
  return order;
}

/// RAM for all that a board holds: what does not fit a board has been found out before.
BoardRoom roomy(const Machine& machine, const PackedScene<float>& scene) {
  BoardRoom room = board_room(machine);
  const MemoryMap map = memory_map_of(scene, machine);
  const std::int64_t bytes = map.used_bytes + map.stack_needed_bytes;
  room.ram_bytes = static_cast<std::uint32_t>(bytes + bytes % 2);
  room.line_pixels = 0;
  return room;
}

models::OperationCost operator-(const models::OperationCost& a, const models::OperationCost& b) {
  return {a.clocks - b.clocks, a.reads - b.reads, a.writes - b.writes};
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
        last_use_ = models::ram_use(event.account);
        return true;
      case ProgramEvent::Kind::access:
        return follow_write(event, elapsed);
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
  bool follow_write(const ProgramEvent& event, models::Duration elapsed) {
    const BusRequest& request = event.request;
    constexpr unsigned k_word_bits = 16;
    if (request.kind != BusRequest::Kind::write || request.address < order_.frame_memory) {
      throw std::logic_error("the program of a board does not only write pixels");
    }
    const std::uint32_t offset = request.address - order_.frame_memory;
    if (offset % models::FrameMemory::k_pixel_bytes == 0) {
      first_word_ = request.value;
      return true;
    }
    const models::OperationCost use = models::ram_use(event.account);
    const std::uint32_t number = offset / models::FrameMemory::k_pixel_bytes;
    const ExecutedPixel pixel{{static_cast<int>(number % order_.frame_width),
                               static_cast<int>(number / order_.frame_width)},
                              first_word_ << k_word_bits | request.value,
                              elapsed - last_,
                              use - last_use_};
    last_ = elapsed;
    last_use_ = use;
    return take_(pixel);
  }

  models::ProgramTime time_;
  const firmware::BoardOrder& order_;
  const PixelTaker& take_;
  models::Duration last_{};
  models::OperationCost last_use_;
  std::uint32_t first_word_ = 0;
};

}  // namespace

void execute_pixels(const Scene& scene, const Machine& machine, int share, const PixelTaker& take) {
  Machine alone = board_alone(machine);
  require_execution(alone);
  const auto packed = packed_scene<float>(scene, picture_format_of(machine));
  const PreparedScene<float> prepared(packed);
  SynthesisArea<float> area(prepared.frame().database);
  const models::PixelRectangle zone = useful_zone_of(prepared.frame());
  const PixelSample sample = pixel_sample(alone, zone, share);
  alone.parameters.allotment = sample.allotment;
  const firmware::BoardOrder order = sample_order(alone, zone, sample.step);
  BoardImage image = board_image(models::numbers_of(alone.parameters.board.arithmetic), prepared,
                                 area.view(), order, roomy(alone, packed));
  PixelFollower follower(alone, order, take);
  models::ProgramSlots slots(1);
  BoardProgram program({image.ram.data(), static_cast<std::uint32_t>(image.ram.size())},
                       program_entry(image), host_routines(alone, image), slots);
  while (follower.follow(program.next())) {
  }
}

}  // namespace maquette::sim
