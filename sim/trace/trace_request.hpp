#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/trace_format.hpp"

namespace maquette::sim {

/// The texts of a command line about traces; those that are not given are empty.
struct TraceOptions {
  std::vector<std::string> files;
  std::string lines;
  std::string window;
  std::string boards;
  bool video = false;
};

/// What of a run is to be traced, and where to.
struct TraceRequest {
  std::vector<std::string> files;  ///< as given; none: no accesses are traced
  std::filesystem::path folder;    ///< of files that are given by a name alone
  std::string lines;               ///< file for the backplanes' lines; empty: they are not traced
  TraceWindow window;
  bool video = false;               ///< the video reader, too
  std::vector<std::size_t> boards;  ///< whose tracks are written, ascending
};

/// The format that a file's extension names. Throws DescriptionError for another one.
const TraceFormat& trace_format(const std::string& file);

/// The file that is written beside a trace for its viewer; empty where there is none. Throws as
/// trace_format.
std::string view_of(const std::string& file);

/// Checks the texts of a command line: the window is "T0..T1", times with units from the frame's
/// start, of which each may be left out; the boards are a list of numbers and ranges, e.g.
/// "0,2..3", which units of functions follow, and empty for all of them; the lines go to a .vcd.
/// Throws DescriptionError that says what is wrong and what is allowed.
TraceRequest trace_request(const TraceOptions& options, std::size_t master_count);

}  // namespace maquette::sim
