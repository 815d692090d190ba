#include "sim/run/executed_sample.hpp"

#include <stdexcept>

#include "models/board/program_cost.hpp"
#include "sim/database/board_image.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/board_programs.hpp"
#include "sim/run/host_arithmetic.hpp"

namespace maquette::sim {

namespace {

using models::mc68000::Account;
using models::mc68000::BusReply;
using models::mc68000::BusRequest;

/// Behind the largest RAM that an MC68000 can have beside a frame memory.
constexpr std::uint32_t k_frame_memory = 0x800000;
constexpr std::uint32_t k_pixel_bytes = 4;

/// A frame memory that tells the pixels that are written, and when.
class PixelRecorder final : public models::mc68000::ExternalBus {
 public:
  PixelRecorder(const models::Kvm02Parameters& board, int width, firmware::Work& arithmetic)
      : board_(board), width_(width), arithmetic_(arithmetic) {}

  /// From here on the program takes time for pixels.
  void begin(const Account& account) {
    last_ = models::program_milliclocks(account, board_);
    arithmetic_ = {};
  }

  /// A pixel is written when its second word is.
  BusReply access(const BusRequest& request, const Account& account) override {
    const std::uint32_t offset = request.address - k_frame_memory;
    if (offset % k_pixel_bytes != 0) {
      const int number = static_cast<int>(offset / k_pixel_bytes);
      const std::int64_t now = models::program_milliclocks(account, board_);
      pixels_.push_back({number % width_, number / width_, now - last_, arithmetic_});
      last_ = now;
      arithmetic_ = {};
    }
    return {};
  }

  [[nodiscard]] std::vector<ExecutedPixel> take() { return std::move(pixels_); }

 private:
  const models::Kvm02Parameters& board_;
  int width_;
  firmware::Work& arithmetic_;
  std::int64_t last_ = 0;
  std::vector<ExecutedPixel> pixels_;
};

firmware::BoardOrder every(std::uint32_t step, const Machine& machine) {
  firmware::BoardOrder order{};
  order.first_unit = step / 2;
  order.unit_step = step;
  order.unit_width = 1;
  order.unit_height = 1;
  order.frame_width = static_cast<std::uint16_t>(machine.parameters.frame_memory.width);
  order.frame_memory = k_frame_memory;
  return order;
}

}  // namespace

std::vector<ExecutedPixel> executed_sample(const PackedScene<float>& packed, const Machine& machine,
                                           std::uint32_t step) {
  const bool executed = executes_package(machine);
  const PreparedScene<float> scene(packed);
  SynthesisArea<float> area(scene.frame().database);
  BoardImage image =
      board_image(scene.frame(), area.view(), every(step, machine), board_room(machine));

  firmware::Work arithmetic{};
  PixelRecorder recorder(machine.parameters.board, machine.parameters.frame_memory.width,
                         arithmetic);
  models::mc68000::NativeCalls routines;
  routines.add(address_of(image.program, "board_synthesis"),
               [&recorder](models::mc68000::ExecutionUnit& unit) {
                 unit.counter.settle();
                 recorder.begin(unit.counter.account());
               });
  if (!executed) {
    host_arithmetic(image.program)(routines, arithmetic);
  }
  models::mc68000::Mc68000 processor(
      {image.ram.data(), static_cast<std::uint32_t>(image.ram.size())}, recorder);
  processor.use(routines);
  processor.registers().program_counter = address_of(image.program, "board_program");
  processor.registers().stack() = image.stack;
  const models::mc68000::Stop stop = processor.run({});
  if (stop.reason != models::mc68000::StopReason::stop_instruction) {
    throw std::logic_error(std::string("the program of a board ends with ") +
                           models::mc68000::name_of(stop.reason));
  }
  return recorder.take();
}

}  // namespace maquette::sim
