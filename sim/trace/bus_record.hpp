#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/bus/instant.hpp"
#include "sim/trace/video_record.hpp"

namespace maquette::sim {

/// A part of the frame's time: from <= instant < to, in ticks since the frame's start.
struct TraceWindow {
  models::Instant from{};
  models::Instant to = models::k_never;

  [[nodiscard]] models::Instant clip(models::Instant instant) const {
    return instant < from ? from : (instant > to ? to : instant);
  }
};

/// One access to a bus, in 56 bytes. Instants count from the frame's start.
struct RecordedAccess {
  static constexpr std::uint8_t k_unanswered = 1;
  static constexpr std::uint8_t k_kept = 2;
  static constexpr std::uint8_t k_test_and_set = 4;

  models::Instant request{};
  models::Instant grant{};         ///< the strobes fall
  models::Duration arbitration{};  ///< how long before the grant it began
  models::Duration acknowledge{};  ///< how long after the grant the slave answered
  models::Duration duration{};     ///< how long after the grant the bus was released
  std::uint64_t address = 0;
  std::uint32_t data = 0;
  std::uint16_t board = 0;  ///< its number
  std::uint8_t write = 0;   ///< 1; a read 0
  /// Sum of: no answer (bus error), the bus was kept until the arbitration by the board of the
  /// access before, a read-modify-write cycle.
  std::uint8_t flags = 0;

  [[nodiscard]] models::Instant decision() const { return grant - arbitration; }
  [[nodiscard]] models::Instant end() const { return grant + duration; }
  [[nodiscard]] bool is_answered() const { return (flags & k_unanswered) == 0; }
  [[nodiscard]] bool is_kept() const { return (flags & k_kept) != 0; }
  [[nodiscard]] bool is_test_and_set() const { return (flags & k_test_and_set) != 0; }
};
static_assert(sizeof(RecordedAccess) == 56);

/// A board that was traced, whether it had accesses or not.
struct RecordedBoard {
  std::string name;
  int level = 0;                          ///< of its requests, 0..4
  std::optional<models::Instant> finish;  ///< when it had no more pixels, if it came to that
};

/// A time for which a board or a function unit had nothing to do.
struct RecordedPause {
  models::Instant from;
  models::Instant to;
};

/// What one master has handed over to another, in a message on the bus.
struct RecordedHandover {
  std::uint16_t from;
  std::uint16_t to;
  models::Instant sent;     ///< the message was requested
  models::Instant arrived;  ///< and has ended
};

/// A request that was not granted when the run was interrupted.
struct StandingRequest {
  std::size_t board;
  models::Instant request;
};

/// One backplane: its accesses in the order of their grants, with the last one before the window
/// and the first one that touches it no more where a kept bus reaches into it.
struct RecordedBus {
  std::string name;
  int data_bits = 16;
  std::vector<RecordedAccess> accesses;
  std::vector<StandingRequest> standing;
};

/// All that happened on the buses of a machine during a window of a frame. Every trace format is
/// made from it.
struct BusRecord {
  TraceWindow window;  ///< ends with the frame at the latest
  std::vector<RecordedBoard> boards;
  std::vector<RecordedBus> buses;
  std::optional<VideoRecord> video;  ///< when it was looked at
  /// Of each board by its number, those that touch the window, in the order of time; of machines
  /// with function units alone.
  std::vector<std::vector<RecordedPause>> pauses = {};
  std::vector<RecordedHandover> handovers = {};  ///< those within the window
};

/// How long a text is expected to be that says so many bytes about each access, and so many more
/// about each access that waited for its grant, and about each line of the video reader.
std::int64_t expected_bytes(const BusRecord& record, std::int64_t per_access, std::int64_t per_wait,
                            std::int64_t per_line);

}  // namespace maquette::sim
