#include "sim/trace/trace_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace maquette::sim {

const TraceFormat* find_trace_format(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  const auto* const found =
      std::find_if(k_trace_formats.begin(), k_trace_formats.end(),
                   [&](const TraceFormat& format) { return format.extension == extension; });
  return found == k_trace_formats.end() ? nullptr : found;
}

std::string trace_extensions() {
  std::string text;
  for (const TraceFormat& format : k_trace_formats) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", format.extension);
  }
  return text;
}

}  // namespace maquette::sim
