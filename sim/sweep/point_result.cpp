#include "sim/sweep/point_result.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/report/flat_json.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr std::string_view k_statistics = "statistics.";

/// Texts may hold bytes that are not UTF-8: they are replaced, not refused.
std::string quoted(const std::string& text) {
  using Json = nlohmann::json;
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string point_json(int point, const std::vector<PointParameter>& parameters,
                       const std::string& study, const PointResult& result) {
  std::string text = fmt::format("{{\n  \"study\": {},\n  \"point\": {},\n  \"parameters\": {{",
                                 quoted(study), point);
  const char* separator = "\n";
  for (const PointParameter& parameter : parameters) {
    text += fmt::format("{}    {}: {}", separator, quoted(parameter.path), quoted(parameter.value));
    separator = ",\n";
  }
  text += "\n  },\n";
  if (result.statistics) {
    text += fmt::format("  \"statistics\": {}}}\n", statistics_json(*result.statistics));
  } else {
    text += fmt::format("  \"failure\": {}\n}}\n", quoted(result.failure));
  }
  return text;
}

PointFile parse_point(const std::string& json, const std::string& name) {
  PointFile file;
  FlatValues statistics;
  bool is_failure = false;
  for (auto& [path, value] : flatten_json(json, name)) {
    if (path.compare(0, k_statistics.size(), k_statistics) == 0) {
      statistics.emplace_back(path.substr(k_statistics.size()), std::move(value));
    } else if (path == "study") {
      file.study = value;
    } else if (path == "failure") {
      is_failure = true;
      file.result.failure = value;
    }
  }
  if (statistics.empty() != is_failure) {
    throw DescriptionError(name + ": statistics or a failure must stand here");
  }
  if (!is_failure) {
    file.result.statistics = read_statistics(statistics, name);
  }
  return file;
}

}  // namespace maquette::sim
