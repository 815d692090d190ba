#include "models/display/video_reader.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "models/bus/kernel_time.hpp"
#include "models/display/video_slots.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using traffic::below;

/// Standards whose times are not whole picoseconds, or the real one.
VideoParameters standard(int kind) {
  VideoParameters video;
  if (kind % 3 != 0) {
    video.lines_per_frame = 29;
    video.frames_per_s = 613;
    video.interlaced = kind % 3 == 1;
    video.pixel_clock_hz = 1.234567e6;
    video.first_active_line_field_1 = 4;
    video.first_active_line_field_2 = 18;
    video.line_blanking = Duration{kind % 2 == 0 ? 300'000 : 7'000'001};
  }
  return video;
}

FrameMemoryParameters memory_of(std::mt19937& generator, const VideoParameters& video) {
  FrameMemoryParameters memory;
  memory.width = 41;
  memory.height = 21;
  memory.video_slot_pixels = 1 + below(generator, 41);
  const double pixel_ps = 1e12 / video.pixel_clock_hz;
  const auto most = std::min(static_cast<int>(memory.video_slot_pixels * pixel_ps) - 2, 10'000'000);
  memory.video_slot_time = Duration{below(generator, most)};
  const auto rest = most - static_cast<int>(memory.video_slot_time.count());
  memory.access_time = Duration{below(generator, std::min(rest, 1'000'000))};
  return memory;
}

/// An event is heard by processes that have come to wait for it.
void start_frame(sc_core::sc_event& event) {
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  event.notify(sc_core::SC_ZERO_TIME);
}

/// A reader that is told of accesses at random instants, and keeps what it showed.
struct Watched {
  struct Shown {
    Instant at;
    std::vector<std::uint64_t> values;
  };

  Watched(const std::string& name, const VideoParameters& video,
          const FrameMemoryParameters& parameters, const VideoWatch& watch)
      : timing(video, parameters.width, parameters.height),
        slots(timing, parameters),
        reader(name.c_str(), video, parameters, watch) {
    reader.observe([this](const LineState& line) {
      if (states.empty() || states.back().at != kernel_now()) {
        states.push_back(
            {kernel_now(), states.empty() ? std::vector<std::uint64_t>(6) : states.back().values});
      }
      states.back().values[static_cast<std::size_t>(line.line)] = line.value;
    });
  }

  void tell(Instant asked) { reader.tell({asked, slots.earliest_access(asked)}); }

  VideoTiming timing;
  VideoSlots slots;
  VideoReader reader;
  std::vector<Shown> states;
};

void check_shown(const Watched& watched, const FrameMemoryParameters& memory) {
  for (const Watched::Shown& shown : watched.states) {
    const ScanPosition position = watched.timing.position(shown.at);
    REQUIRE(shown.values[0] == static_cast<std::uint64_t>(position.field));
    REQUIRE(shown.values[1] == static_cast<std::uint64_t>(position.line));
    REQUIRE(shown.values[2] == static_cast<std::uint16_t>(position.row));
    REQUIRE((shown.values[4] == 1) == (watched.slots.earliest_access(shown.at) != shown.at));
    if (shown.values[5] > 0) {
      REQUIRE(shown.values[4] == 1);
    }
    if (shown.values[3] == 1 && memory.access_time > Duration::zero()) {
      REQUIRE(shown.values[4] == 1);
    }
  }
}

}  // namespace

TEST_CASE("the reader is where the closed form has it, and lets accesses begin as that does") {
  sc_core::sc_event start("start");
  std::mt19937 generator(625);
  std::vector<FrameMemoryParameters> memories;
  std::vector<std::unique_ptr<Watched>> all;
  constexpr int k_accesses = 1500;
  const Duration span = std::chrono::milliseconds(8);
  for (int kind = 0; kind < 24; ++kind) {
    const VideoParameters video = standard(kind);
    memories.push_back(memory_of(generator, video));
    const Duration from{below(generator, 2'000'000'000)};
    all.push_back(std::make_unique<Watched>("reader" + std::to_string(kind), video, memories.back(),
                                            VideoWatch{start, from, from + span, {}}));
    for (int one = 0; one < k_accesses; ++one) {
      const auto within = static_cast<std::int64_t>(generator() % 7'000'000'000U);
      all.back()->tell(from + k_tick + Duration{within});
    }
  }
  start_frame(start);
  sc_core::sc_start();
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(i);
    CHECK(all[i]->reader.compared() == k_accesses);
    CHECK(all[i]->states.size() > 100);
    all[i]->states.erase(all[i]->states.begin());  // before it was looked at
    check_shown(*all[i], memories[i]);
  }
}

/// Tells a reader of an access in the way of a slot that begins by `error` beside the closed form.
void tell_wrongly(Duration from_slot, Duration error) {
  sc_core::sc_event start("start");
  const FrameMemoryParameters memory;
  const VideoParameters video;
  VideoReader reader("reader", video, memory, {start, {}, std::chrono::milliseconds(3), {}});
  const VideoSlots slots(VideoTiming(video, memory.width, memory.height), memory);
  const Instant slot = 22 * Duration{64'000'000} + Duration{10'500'000};  // line 23
  const Instant asked = slot + from_slot;
  reader.tell({asked, slots.earliest_access(asked) + error});
  start_frame(start);
  CHECK_THROWS_AS(sc_core::sc_start(), sc_core::sc_report);
}

TEST_CASE("an access that waits a tick too long is found") {
  tell_wrongly(Duration{-249'999}, k_tick);
}

TEST_CASE("an access that begins a tick before the end of a slot is found") {
  tell_wrongly(Duration{100'000}, -k_tick);
}

TEST_CASE("an access that waits for nothing is found") { tell_wrongly(Duration{-600'000}, k_tick); }

TEST_CASE("the reader ends when there is no more to see, and without priority keeps nobody out") {
  sc_core::sc_event start("start");
  FrameMemoryParameters memory;
  memory.video_priority = false;
  bool is_over = false;
  VideoReader reader("reader", VideoParameters{}, memory,
                     {start, {}, k_never, [&is_over] { return is_over; }});
  reader.tell({Instant{1'420'000'000}, Instant{1'420'000'000}});
  start_frame(start);
  sc_core::sc_start(10, sc_core::SC_MS);
  CHECK(reader.compared() == 1);
  CHECK_FALSE(reader.closed.read());
  CHECK(reader.line.read() == 157);
  CHECK(reader.field.read() == 1);
  CHECK(reader.row.read() == 2 * (157 - 23));
  is_over = true;
  sc_core::sc_start();
  CHECK(kernel_now() == Duration{64'000'000} * 157);
}
