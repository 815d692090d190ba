#pragma once

#include <cstdint>

#include "models/board/arithmetic_costs.hpp"
#include "models/bus/duration.hpp"

namespace maquette::models {

/// When a master gives the bus back (VM02 data sheet p. 2-53/54): after each access ("indirect"),
/// or at the end of its block of words ("direct"), earlier when BCLR is raised by a higher level.
enum class ReleasePolicy { each_access, block };

/// Whether the bus is kept between the accesses of a burst.
constexpr bool keeps_bus(ReleasePolicy policy) {
  switch (policy) {
    case ReleasePolicy::each_access:
      return false;
    case ReleasePolicy::block:
      break;
  }
  return true;
}

/// When a board writes its pixels: each as soon as it is known, or a line of its pixels together.
enum class PixelWrite { pixel, line };

/// Whether pixels are kept until their line is complete.
constexpr bool keeps_line(PixelWrite write) {
  switch (write) {
    case PixelWrite::pixel:
      return false;
    case PixelWrite::line:
      break;
  }
  return true;
}

/// Where boards read the scene: in their RAM, or over the bus in a memory that they share.
enum class DatabasePlace { own_copy, shared };

/// Whether boards read the scene over the bus.
constexpr bool is_shared(DatabasePlace place) {
  switch (place) {
    case DatabasePlace::own_copy:
      return false;
    case DatabasePlace::shared:
      break;
  }
  return true;
}

/// A KVM02 board: processor, RAM, its side of the bus.
struct Kvm02Parameters {
  double clock_hz = 8e6;
  ArithmeticCosts arithmetic;
  /// Added to every call of the arithmetic package: operands moved, JSR, the result stored;
  /// measured on the board's program (tools/program_costs).
  OperationCost call_overhead{66, 12, 3.8};
  std::int64_t ram_bytes = std::int64_t{128} * 1024;
  Clocks ram_read_wait_clocks = 2;
  Clocks ram_write_wait_clocks = 1;
  Duration refresh_period{15'000'000};  ///< one RAM cycle is stolen per period; 0 is off
  Clocks refresh_clocks = 4;            ///< what the stolen cycle costs
  Clocks access_clocks = 5;             ///< off-board access of a fast slave, bus held
  Duration access_slack{70'000};        ///< slave access time that costs no extra clock
  Clocks word_gap_clocks = 6;           ///< between the end of one word's access and the next
  Duration dual_port_access{625'000};   ///< of its own RAM, seen from the bus
  ReleasePolicy release = ReleasePolicy::each_access;
  PixelWrite pixel_write = PixelWrite::pixel;
  DatabasePlace database = DatabasePlace::own_copy;
  std::int64_t database_cache_bytes = 0;  ///< of a shared database
  /// The part of a load that reads the datum, which a bus access replaces: two words of MOVE.L.
  OperationCost database_read{8, 2, 0};
};

}  // namespace maquette::models
