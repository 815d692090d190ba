#pragma once

#include <array>
#include <string>

#include "sim/trace/chrome_trace.hpp"
#include "sim/trace/svg_trace.hpp"
#include "sim/trace/trace_format.hpp"
#include "sim/trace/vcd_trace.hpp"

namespace maquette::sim {

/// The formats that there are, one row each.
inline constexpr std::array k_trace_formats = {k_chrome_trace, k_vcd_trace, k_svg_trace};

/// The format of a file by its extension; nothing for one that no format has.
[[nodiscard]] const TraceFormat* find_trace_format(const std::string& file);

/// The extensions of all formats, for messages: ".json, .vcd, .svg".
[[nodiscard]] std::string trace_extensions();

}  // namespace maquette::sim
