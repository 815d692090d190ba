#include "sim/run/time_forecast.hpp"

#include "sim/run/frame_recorder.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette;
using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr models::PixelRectangle k_zone{2, 3, 16, 8};

Description described(std::vector<std::string> overrides) {
  overrides.insert(overrides.end(), {"frame_memory.width=48 pixels",
                                     "frame_memory.height=36 pixels", "board.refresh_period=0 s"});
  return load_description(
      {data_directory() / "scenes/photo4.yaml", {}, overrides, data_directory().string()});
}

/// A frame whose pixels cost a branch each but for one, which costs so many.
RecordedFrame frame_with(std::size_t costly, std::uint32_t branches) {
  RecordedFrame frame;
  frame.useful_zone = k_zone;
  frame.pixels.resize(static_cast<std::size_t>(k_zone.pixels()));
  for (models::SynthesizedPixel& pixel : frame.pixels) {
    pixel.work = {};
    pixel.work[firmware::Operation::node] = 1;
  }
  frame.pixels[costly].work[firmware::Operation::node] = branches;
  return frame;
}

TEST_CASE("the board that would compute for too long is named, with how long") {
  Machine machine = described({"board.clock=1 kHz"}).machine;
  machine.parameters.board.arithmetic.operations = {};
  constexpr auto k_node = static_cast<std::size_t>(firmware::Operation::node);
  machine.parameters.board.arithmetic.operations[k_node].clocks = 1000;
  CHECK_NOTHROW(require_computing_time(machine, frame_with(6, 8'639'000)));
  CHECK_THROWS_WITH(require_computing_time(machine, frame_with(6, 8'640'000)),
                    ContainsSubstring("board2 would compute for at least 100 days"));
  CHECK_THROWS_WITH(require_computing_time(machine, frame_with(5, 17'280'000)),
                    ContainsSubstring("board1 would compute for at least 106.8 days"));
  machine.parameters.allotment.assignment = models::Assignment::on_demand;
  CHECK_NOTHROW(require_computing_time(machine, frame_with(5, 17'280'000)));
  RecordedFrame costly = frame_with(0, 8'000'000);
  costly.pixels.assign(costly.pixels.size(), costly.pixels.front());
  CHECK_THROWS_WITH(require_computing_time(machine, costly),
                    ContainsSubstring("a board would compute for at least 2963 days"));
}

TEST_CASE("a sample tells frames that may take long from those that do not") {
  const Description slow = described({"board.clock=1 kHz"});
  const Description fast = described({});
  const RecordedFrame frame = record_frame(slow.scene, picture_format_of(slow.machine), 1);
  const auto may = [&frame](const Machine& machine, std::uint32_t factor) {
    return may_take_long(likely_computing_s(machine, frame.useful_zone, frame.preprocessing,
                                            [&](const models::PixelPosition& position) {
                                              firmware::Work work = frame.at(position).work;
                                              for (std::uint32_t& count : work.counts) {
                                                count *= factor;
                                              }
                                              return work;
                                            }));
  };
  CHECK_FALSE(may(fast.machine, 1));
  CHECK_FALSE(may(slow.machine, 1));
  CHECK(may(slow.machine, 10'000));
}

TEST_CASE("loading and transfers that take too long are found in closed form") {
  models::FrameSetup setup;
  setup.useful_zone = k_zone;
  setup.images.assign(4, std::vector<unsigned char>(60'000));
  CHECK_NOTHROW(require_transfer_time(described({}).machine, setup));
  CHECK_THROWS_WITH(
      require_transfer_time(
          described({"host.clock=1 kHz", "host.word_clocks=100000 clocks"}).machine, setup),
      ContainsSubstring("the host would load the boards for at least 138.9 days"));
  setup.images.clear();
  setup.useful_zone = {0, 0, 768, 575};
  const std::string dear = "bus.arbitration_clocks=20000 clocks";
  CHECK_THROWS_WITH(
      require_transfer_time(described({"bus.clock=1 kHz", dear}).machine, setup),
      ContainsSubstring("the bus would be busy with the pixels for at least 204.4 days"));
  CHECK_NOTHROW(require_transfer_time(
      described({"bus.clock=1 kHz", dear, "board.release=block"}).machine, setup));
  CHECK_NOTHROW(require_transfer_time(
      described({"bus.clock=1 kHz", dear, "bus.level=ideal"}).machine, setup));
}

}  // namespace
