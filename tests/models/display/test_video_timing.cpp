#include <map>
#include <random>
#include <stdexcept>

#include "models/display/video_slots.hpp"
#include "models/display/video_timing.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using traffic::below;

const VideoParameters k_625;

// A small standard whose times are not whole picoseconds.
VideoParameters small_standard(bool interlaced) {
  VideoParameters small;
  small.lines_per_frame = 29;
  small.frames_per_s = 613;
  small.interlaced = interlaced;
  small.pixel_clock_hz = 1.234567e6;
  small.first_active_line_field_1 = 4;
  small.first_active_line_field_2 = 18;
  small.line_blanking = Duration{7'000'001};
  return small;
}

struct Scan {
  std::int64_t line;  // from instant 0
  int row;
  int column;
};

// Every pixel of the first frames by walking along the lines, in long double.
std::map<std::int64_t, Scan> walk(const VideoParameters& parameters, int width, int height,
                                  int frames) {
  std::map<std::int64_t, Scan> scans;
  const long double line_ps =
      1e12L / (static_cast<long double>(parameters.lines_per_frame) * parameters.frames_per_s);
  for (int line = 0; line < frames * parameters.lines_per_frame; ++line) {
    const int number = line % parameters.lines_per_frame + 1;
    int row = number - parameters.first_active_line_field_1;
    if (parameters.interlaced) {
      row = number >= parameters.first_active_line_field_2
                ? 2 * (number - parameters.first_active_line_field_2) + 1
                : 2 * row;
    }
    if (row < 0 || row >= height) {
      continue;
    }
    const auto active =
        static_cast<std::int64_t>(line * line_ps + 1e-6L) + parameters.line_blanking.count();
    for (int column = 0; column < width; ++column) {
      const auto pixel = static_cast<std::int64_t>(
          column * 1e12L / static_cast<long double>(parameters.pixel_clock_hz) + 1e-6L);
      scans[active + pixel] = {line, row, column};
    }
  }
  return scans;
}

TEST_CASE("the 625-line standard") {
  const VideoTiming timing(k_625, 768, 575);
  CHECK(timing.line_period().times(1) == Duration{64'000'000});
  CHECK(timing.line_period().times(625 * 25) == Duration{1'000'000'000'000});
  CHECK(timing.pixel_period().times(944) == Duration{64'000'000});
  CHECK(timing.row_of_line(21) == -1);
  CHECK(timing.row_of_line(22) == 0);     // line 23
  CHECK(timing.row_of_line(309) == 574);  // line 310
  CHECK(timing.row_of_line(310) == -1);
  CHECK(timing.row_of_line(335) == 1);    // line 336
  CHECK(timing.row_of_line(621) == 573);  // line 622: half of the 575 rows, less one
  CHECK(timing.row_of_line(622) == -1);
  const ScanPosition second = timing.position(Instant{20'000'000'000});
  CHECK(second.field == 2);
  CHECK(timing.position(Instant{19'999'999'999}).field == 1);
  CHECK(second.line == 313);
  CHECK(timing.position(Instant{40'000'000'000}).frame == 1);
}

TEST_CASE("the position is what a walk along the lines finds, the last scan too") {
  for (const bool interlaced : {true, false}) {
    const VideoParameters parameters = small_standard(interlaced);
    constexpr int k_width = 41;
    constexpr int k_height = 21;
    const VideoTiming timing(parameters, k_width, k_height);
    const auto scans = walk(parameters, k_width, k_height, 3);
    std::vector<std::vector<std::int64_t>> instants(k_width * k_height);
    for (const auto& [instant, scan] : scans) {
      const ScanPosition position = timing.position(Instant{instant});
      REQUIRE(position.row == scan.row);
      REQUIRE(position.column == scan.column);
      REQUIRE(position.line - 1 + position.frame * parameters.lines_per_frame == scan.line);
      const ScanPosition before = timing.position(Instant{instant - 1});
      REQUIRE(before.column == scan.column - 1);
      instants[static_cast<std::size_t>(scan.row * k_width + scan.column)].push_back(instant);
    }
    std::mt19937 generator(5);
    for (int one = 0; one < 20'000; ++one) {
      const int column = below(generator, k_width);
      const int row = below(generator, k_height);
      const auto& own = instants[static_cast<std::size_t>(row * k_width + column)];
      REQUIRE(own.size() == 3);
      const std::int64_t asked =
          one % 2 == 0 ? own[static_cast<std::size_t>(below(generator, 3))] - one % 4 / 2
                       : static_cast<std::int64_t>(generator());
      const auto last = timing.last_scan(column, row, Instant{asked});
      const auto after = std::upper_bound(own.begin(), own.end(), asked);
      REQUIRE(last.has_value() == (after != own.begin()));
      if (last) {
        REQUIRE(last->count() == *std::prev(after));
      }
    }
  }
}

TEST_CASE("a picture that does not fit into the standard is refused") {
  CHECK_NOTHROW(VideoTiming(k_625, 768, 575));
  CHECK_NOTHROW(VideoTiming(k_625, 789, 579));
  CHECK_THROWS_AS(VideoTiming(k_625, 790, 575), std::invalid_argument);
  CHECK_THROWS_AS(VideoTiming(k_625, 768, 582), std::invalid_argument);
  CHECK_THROWS_AS(VideoTiming(k_625, 0, 575), std::invalid_argument);
}

TEST_CASE("slots: the closed form is what trying every slot finds") {
  for (const bool interlaced : {true, false}) {
    for (const int slot_pixels : {1, 4, 16, 41}) {
      VideoParameters video = small_standard(interlaced);
      if (slot_pixels == 4) {
        video.line_blanking = Duration{300'000};  // an access on the line before meets a slot
      }
      const VideoTiming timing(video, 41, 21);
      FrameMemoryParameters memory;
      memory.video_slot_pixels = slot_pixels;
      memory.video_slot_time = Duration{slot_pixels * 300'000};
      memory.access_time = Duration{slot_pixels == 1 ? 500'000 : 1'100'000};
      const VideoSlots slots(timing, memory);

      std::vector<std::int64_t> starts;
      for (const auto& [instant, scan] : walk(video, 41, 21, 2)) {
        if (scan.column % slot_pixels == 0) {
          starts.push_back(instant);
        }
      }
      const auto brute_force = [&](std::int64_t access) {
        for (const std::int64_t start : starts) {
          if (access < start + memory.video_slot_time.count() &&
              access + memory.access_time.count() > start) {
            access = start + memory.video_slot_time.count();
          }
        }
        return access;
      };
      std::mt19937 generator(17);
      const std::int64_t edges[] = {-memory.access_time.count() - 1,
                                    -memory.access_time.count(),
                                    1 - memory.access_time.count(),
                                    -1,
                                    0,
                                    memory.video_slot_time.count() - 1,
                                    memory.video_slot_time.count()};
      for (const std::int64_t start : starts) {
        for (const std::int64_t edge : edges) {
          REQUIRE(slots.earliest_access(Instant{start + edge}).count() ==
                  brute_force(start + edge));
        }
      }
      for (int one = 0; one < 3000; ++one) {
        const auto asked = static_cast<std::int64_t>(generator() % 3'200'000'000U);
        REQUIRE(slots.earliest_access(Instant{asked}).count() == brute_force(asked));
      }
    }
  }
}

TEST_CASE("slots that leave no room for an access are refused") {
  const VideoTiming timing(k_625, 768, 575);
  FrameMemoryParameters memory;
  CHECK_NOTHROW(VideoSlots(timing, memory));
  memory.access_time = Duration{684'745};  // 16 pixels of 14.75 MHz are 1084745.7 ps
  CHECK_NOTHROW(VideoSlots(timing, memory));
  memory.access_time = Duration{684'746};
  CHECK_THROWS_AS(VideoSlots(timing, memory), std::invalid_argument);
  memory.access_time = Duration{250'000};
  memory.video_slot_pixels = 0;
  CHECK_THROWS_AS(VideoSlots(timing, memory), std::invalid_argument);
}

}  // namespace
