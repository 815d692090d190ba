#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "sim/trace/bus_record.hpp"

namespace maquette::sim {

/// A format of trace files. Each is declared beside its own functions and listed in one row of
/// k_trace_formats.
struct TraceFormat {
  std::string_view extension;  ///< of its files, e.g. ".vcd"
  /// Writes a record with the tracks of these boards.
  void (*write)(const BusRecord& record, const std::vector<std::size_t>& boards,
                std::ostream& stream);
  /// About how long that will be.
  std::int64_t (*expected_bytes)(const BusRecord& record);
  /// Of a file that is written beside the trace for its viewer; empty: there is none.
  std::string_view view_extension{};
  /// Its first line, by which such a file is known from one that a user has saved.
  std::string_view view_mark{};
  /// Writes it; `trace` is the name of the trace.
  void (*write_view)(const BusRecord& record, const std::vector<std::size_t>& boards,
                     const std::string& trace, std::ostream& stream) = nullptr;
};

}  // namespace maquette::sim
