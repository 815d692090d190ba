#pragma once

#include <vector>

#include "models/arithmetic_costs.hpp"
#include "models/duration.hpp"

namespace maquette::models {

/// Which master the arbiter of the bus prefers among those of the same instant.
enum class ArbitrationPolicy { priority, round_robin };

/// How exactly the bus is simulated: every request arbitrated at its instant; masters that run
/// ahead of one another for a quantum; or no contention at all.
enum class BusLevel { transaction, decoupled, ideal };

/// When a master gives the bus back (VM02 data sheet p. 2-53/54): after each access ("indirect"),
/// or at the end of its block of words ("direct"), earlier when BCLR is raised by a higher level.
enum class ReleasePolicy { each_access, block };

/// When a board writes its pixels: each as soon as it is known, or a line of its pixels together.
enum class PixelWrite { pixel, line };

/// Where boards read the scene: in their RAM, or over the bus in a memory that they share.
enum class DatabasePlace { own_copy, shared };

/// The units in which the boards take the pixels of the useful zone, and their order.
enum class Allotment { interleaved_pixels, interleaved_lines, bands, tiles };

/// The VERSAbus backplane with its arbiter.
struct VersaBusParameters {
  int data_width_bits = 16;       ///< 16 or 32
  double clock_hz = 8e6;          ///< in which the clocks below are stated
  Clocks arbitration_clocks = 4;  ///< bus free and requested, to grant
  Clocks handover_clocks = 1;     ///< added when the master changes
  ArbitrationPolicy arbitration = ArbitrationPolicy::priority;
  Duration timeout{64'000'000};  ///< of one access; 0 is off
  BusLevel level = BusLevel::transaction;
  Duration quantum{1'000'000'000};  ///< of run-ahead, when decoupled
};

/// Where a master sits on the bus.
struct BusMasterPlace {
  int level = 0;     ///< request level 0..4; 4 is the highest
  int position = 0;  ///< in the daisy chain of its level; 0 is nearest to the arbiter
};

/// A KVM02 board: processor, RAM, its side of the bus.
struct Kvm02Parameters {
  double clock_hz = 8e6;
  ArithmeticCosts arithmetic;
  /// Added to every call of the arithmetic package: JSR, one operand loaded, the result stored.
  OperationCost call_overhead{52, 9, 4};
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

/// The frame memory: geometry, planes, access from the bus.
struct FrameMemoryParameters {
  int width = 768;
  int height = 575;
  int red_bits = 8;
  int green_bits = 8;
  int blue_bits = 8;
  int depth_bits = 0;                 ///< 0: the display has no depth planes
  int ports = 1;                      ///< each with a backplane of its own
  Duration access_time{250'000};      ///< data strobe to acknowledge, no video conflict
  bool video_priority = true;         ///< the video reader's slots delay the bus port
  int video_slot_pixels = 16;         ///< pixels fetched by one video slot
  Duration video_slot_time{400'000};  ///< how long a slot keeps the memory
};

/// The video standard that the video reader follows.
struct VideoParameters {
  int lines_per_frame = 625;
  int frames_per_s = 25;
  bool interlaced = true;
  double pixel_clock_hz = 14.75e6;
  int first_active_line_field_1 = 23;  ///< line numbers from 1
  int first_active_line_field_2 = 336;
  Duration line_blanking{10'500'000};  ///< line start to first active pixel
};

/// The EXORmacs host that writes code and database into the boards' RAM before the frame.
struct HostParameters {
  BusMasterPlace place{4, 0};
  double clock_hz = 8e6;
  Clocks word_clocks = 22;  ///< of its copying loop, per 16-bit word, besides the bus access
  bool loads_code = true;   ///< besides the database
};

/// How boards come to their units: every n-th one, or the next one of a counter that they share.
enum class Assignment { fixed, on_demand };

/// How a board claims a unit: TAS on the counter's lock until it is free, MOVE.L of the counter,
/// ADDQ.L, MOVE.L back, MOVE.B that clears the lock. Processor clocks besides the bus accesses.
struct ClaimParameters {
  Clocks modify_clocks = 2;   ///< within the bus cycle of TAS, between its read and its write
  Clocks spin_clocks = 28;    ///< from a TAS that failed to the next, times the number of boards
  Clocks read_clocks = 16;    ///< from the TAS that succeeded to the counter's read
  Clocks update_clocks = 22;  ///< from there to the counter's write
  Clocks unlock_clocks = 6;   ///< from there to the write that clears the lock
  Clocks finish_clocks = 24;  ///< from there to the first pixel
};

/// How the pixels of the useful zone are given to the boards.
struct AllotmentParameters {
  Allotment order = Allotment::interleaved_pixels;
  int tile_width = 32;
  int tile_height = 32;
  Assignment assignment = Assignment::fixed;
  ClaimParameters claim;
};

/// A memory board on the bus, of machines whose boards share something.
struct SharedMemoryParameters {
  Duration access_time{250'000};  ///< data strobe to acknowledge
};

/// A whole machine as the models need it.
struct MachineParameters {
  std::vector<BusMasterPlace> boards;  ///< one per board, in board order
  Kvm02Parameters board;
  VersaBusParameters bus;
  FrameMemoryParameters frame_memory;
  VideoParameters video;
  HostParameters host;
  AllotmentParameters allotment;
  SharedMemoryParameters shared_memory;
};

}  // namespace maquette::models
