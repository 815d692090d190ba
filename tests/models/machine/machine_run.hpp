#pragma once

#include <string>
#include <utility>

#include "models/machine/ccett_machine.hpp"
#include "tests/catch.hpp"
#include "tests/models/board/source_of_pixels.hpp"

/// Whole machines for tests.
namespace maquette::models::traffic {

inline constexpr Duration k_clock{125'000};
inline constexpr Duration k_word = 7 * k_clock;

inline std::uint32_t colour(PixelPosition position) {
  return static_cast<std::uint32_t>(position.column * 70'001 + position.row * 131) & 0xFFFFFFU;
}

inline std::uint32_t uneven_work(PixelPosition position) {
  return 200 + static_cast<std::uint32_t>(position.column * 7919 + position.row * 104'729) % 900;
}

inline MachineParameters machine(int boards) {
  MachineParameters parameters;
  parameters.boards = places(boards);
  parameters.board = plain_board();
  parameters.frame_memory.width = 64;
  parameters.frame_memory.height = 48;
  parameters.frame_memory.video_priority = false;
  return parameters;
}

inline AllotmentParameters cut_into(Allotment order, int tile_width, int tile_height) {
  AllotmentParameters parameters;
  parameters.order = order;
  parameters.tile_width = tile_width;
  parameters.tile_height = tile_height;
  return parameters;
}

/// A machine with the source that feeds it.
struct Run {
  Run(const std::string& name, const MachineParameters& parameters, const FrameSetup& setup,
      AllottedPixels::Glue glue = uneven_work, std::uint32_t preprocessing = 5000)
      : source(PixelAllotment(parameters.allotment, setup.useful_zone,
                              static_cast<int>(parameters.boards.size())),
               colour, std::move(glue), preprocessing),
        machine(name.c_str(), parameters, source, setup) {}

  AllottedPixels source;
  CcettMachine machine;
};

inline FrameSetup zone(const PixelRectangle& rectangle) {
  FrameSetup setup;
  setup.useful_zone = rectangle;
  return setup;
}

inline void check_states(const MachineStatistics& statistics) {
  Duration busy{};
  Duration waited{};
  for (const BoardStatistics& board : statistics.boards) {
    CHECK(board.compute + board.wait_grant + board.transfer + board.idle == statistics.frame_time);
    CHECK(board.idle >= Duration::zero());
    busy += board.transfer;
    waited += board.wait_grant;
  }
  CHECK(busy + statistics.host.transferred == total(statistics.bus).busy);
  CHECK(waited + statistics.host.waited == total(statistics.bus).waited);
}

}  // namespace maquette::models::traffic
