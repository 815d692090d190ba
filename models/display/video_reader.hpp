#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <systemc>
#include <vector>

#include "models/bus/instant.hpp"
#include "models/bus/line_state.hpp"
#include "models/display/frame_memory_parameters.hpp"
#include "models/display/memory_access.hpp"
#include "models/display/slot_walk.hpp"
#include "models/display/video_parameters.hpp"
#include "models/display/video_timing.hpp"

namespace maquette::models {

/// When one looks at the video reader: a span of the frame, and what tells that there is no more to
/// see, which is asked once a line.
struct VideoWatch {
  const sc_core::sc_event& start;  ///< of the frame; kept by reference
  Duration from{};                 ///< since then
  Duration to = k_never;
  std::function<bool()> is_over;
};

/// The video reader for whoever looks at it: a process that goes from line to line and from slot to
/// slot as the beam does, counts lines and rows, and keeps accesses to the frame memory waiting.
///
/// Nobody else needs it: the memory decides by VideoSlots, the closed form, ahead of the kernel and
/// without a process. Each access that the reader is told of it holds against that form, to the
/// tick: `closed` keeps accesses out that would not end before the next slot, and lets those that
/// wait begin in the instant in which the slot ends.
class VideoReader : public sc_core::sc_module {
 public:
  VideoReader(const sc_core::sc_module_name& name, const VideoParameters& standard,
              const FrameMemoryParameters& parameters, VideoWatch watch);

  sc_core::sc_signal<int> field;     ///< 1 or 2
  sc_core::sc_signal<int> line;      ///< of the standard, from 1
  sc_core::sc_signal<int> row;       ///< of the picture, or -1 on a line that shows none
  sc_core::sc_signal<bool> fetches;  ///< a slot keeps the memory
  sc_core::sc_signal<bool> closed;   ///< no access may begin
  sc_core::sc_signal<int> waiting;   ///< accesses that a slot keeps waiting

  /// The memory has an access, perhaps ahead of the kernel, and at most a tick behind it. The
  /// reader reports an error when it would let it begin at another instant.
  void tell(const MemoryAccess& access);

  /// How many accesses it has held against the closed form.
  [[nodiscard]] std::int64_t compared() const { return compared_; }

  /// Shows `observer` its signals as lines: FIELD, LINE, ROW (all ones: none), SLOT, CLOSED and
  /// WAITING; each at once, and then as it changes. Before the simulation starts.
  void observe(LineObserver observer);

 private:
  void run();
  void begin(Instant now);
  void step(Instant now);
  [[nodiscard]] Instant next_change() const;
  void begin_line();
  void step_slot(Instant now);
  void aim_at_slot();
  void take(const MemoryAccess& access);
  void compare(const MemoryAccess& access, Instant begun);
  [[nodiscard]] Instant middle_of(std::int64_t frame) const;
  void drive();
  void show(std::size_t number, std::uint64_t value);

  VideoParameters standard_;
  VideoTiming timing_;
  std::optional<SlotWalk> slots_;
  VideoWatch watch_;
  sc_core::sc_event told_;

  std::int64_t lines_ = 0;  // since instant 0, less one
  int line_ = 1;
  int row_ = -1;
  int field_ = 1;
  bool fetches_ = false;
  bool closed_ = false;
  Instant closed_changed_{};
  Instant began_{};
  Instant next_line_ = k_never;
  Instant next_field_ = k_never;
  Instant next_close_ = k_never;  // of the slot that comes or is
  Instant next_fetch_ = k_never;
  Instant next_open_ = k_never;
  bool is_over_ = false;
  std::multimap<Instant, MemoryAccess> told_accesses_;
  std::vector<MemoryAccess> waiting_;
  std::int64_t compared_ = 0;
  LineObserver observer_;
  std::vector<std::uint64_t> shown_;
};

}  // namespace maquette::models
