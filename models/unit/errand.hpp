#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "models/board/pixel_source.hpp"
#include "models/bus/instant.hpp"

namespace maquette::models {

class FunctionUnit;
struct Errand;

/// Neighbouring legs of a pixel that are done in one place.
struct Hop {
  static constexpr int k_at_board = -1;

  int kind;                   ///< of the units that do it, as a number of UnitKind, or k_at_board
  std::uint32_t numbers_in;   ///< handed to whoever does it
  std::uint32_t numbers_out;  ///< and handed back
  Duration time;
};

/// The board that has begun a pixel and writes it.
struct ErrandHome {
  std::uint64_t mailbox;                   ///< bus address at which it takes what comes back
  std::function<void(Errand&)> take_back;  ///< the next hop is the board's
};

/// A pixel on its way through a board and its units: it is in one place at a time.
struct Errand {
  int board = 0;
  const ErrandHome* home = nullptr;
  std::int64_t number = 0;  ///< of the board's pixels, from 0
  SynthesizedPixel pixel{};
  std::vector<Hop> hops;
  std::size_t next = 0;             ///< the hop that it is before or in
  FunctionUnit* place = nullptr;    ///< the unit that keeps a place for it
  int last_kind = Hop::k_at_board;  ///< that has served it last
  Instant since{};                  ///< it waits: for a place, or in a queue

  [[nodiscard]] bool is_done() const { return next == hops.size(); }
  [[nodiscard]] const Hop& hop() const { return hops[next]; }
  [[nodiscard]] bool is_at_board() const { return is_done() || hop().kind == Hop::k_at_board; }
};

/// An errand has gone from one master of the bus to another: boards by their numbers, then units.
struct Handover {
  int from;
  int to;
  Instant sent;     ///< its message was requested
  Instant arrived;  ///< and has ended
};

using HandoverObserver = std::function<void(const Handover&)>;

}  // namespace maquette::models
