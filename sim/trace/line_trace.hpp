#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/report/output_file.hpp"
#include "sim/trace/bus_record.hpp"
#include "sim/trace/vcd_text.hpp"

namespace maquette::sim {

/// A value change dump of the backplanes' lines during a window of a frame, written while they
/// change; time 0 is the frame's start. Of several changes of a line in one instant the last is
/// seen.
class LineTrace {
 public:
  /// Throws DescriptionError when the file cannot be begun.
  LineTrace(const std::string& file, const TraceWindow& window);

  /// Adds a line and what it shows, before all changes. Returns its number.
  std::size_t add(const VcdVariable& line, std::uint64_t value);

  /// From an instant of the frame on a line shows a value. Instants never go back; those before the
  /// frame are negative.
  void change(std::size_t line, models::Instant at, std::uint64_t value);

  /// Ends the window with the frame at the latest, and publishes the file. Throws DescriptionError.
  void publish(models::Instant frame_end);

 private:
  void show_before(models::Instant at);

  OutputFile file_;
  VcdText text_;
  TraceWindow window_;
  models::Instant latest_ = models::Instant::min();  // of the changes
  bool has_begun_ = false;
};

}  // namespace maquette::sim
