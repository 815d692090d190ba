#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <string>

#include "sim/report/output_file.hpp"
#include "sim/trace/line_trace.hpp"
#include "sim/trace/trace_request.hpp"

namespace maquette::sim {

/// The trace files of a run, begun before it so that it does not find out at its end that they can
/// not be written.
class TraceFiles {
 public:
  /// Throws DescriptionError when a file cannot be begun.
  explicit TraceFiles(TraceRequest request);

  /// The trace to be shown the backplanes' lines, if one is asked for.
  [[nodiscard]] LineTrace* lines() { return lines_ ? &*lines_ : nullptr; }

  /// What is to be known before the files are written: that they will be large, that the frame was
  /// over before the window began. Whole lines; empty when there is nothing to say.
  [[nodiscard]] std::string remarks(const BusRecord& record, models::Instant frame_end) const;

  /// Writes and publishes all files. Throws DescriptionError.
  void write(const BusRecord& record, models::Instant frame_end);

 private:
  TraceRequest request_;
  std::list<OutputFile> files_;  // in the order of the request
  std::list<OutputFile> views_;  // of those that have one, likewise
  std::optional<LineTrace> lines_;
};

}  // namespace maquette::sim
