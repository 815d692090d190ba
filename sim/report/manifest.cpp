#include "sim/report/manifest.hpp"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "sim/report/digest.hpp"

namespace maquette::sim {

InputDigest digest_of(const InputFile& file) {
  return {file.path, sha1_of(file.content.data(), file.content.size())};
}

void measure_process(Manifest& manifest) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  constexpr std::int64_t unit_bytes = 1024;  // of ru_maxrss on Linux
  rusage own{};
  rusage children{};
  getrusage(RUSAGE_SELF, &own);
  getrusage(RUSAGE_CHILDREN, &children);
  manifest.processor_time_s = seconds(own.ru_utime) + seconds(own.ru_stime) +
                              seconds(children.ru_utime) + seconds(children.ru_stime);
  manifest.peak_memory_bytes = own.ru_maxrss * unit_bytes;
  manifest.peak_child_memory_bytes = children.ru_maxrss * unit_bytes;
}

std::string manifest_json(const Manifest& manifest) {
  using Json = nlohmann::ordered_json;
  Json inputs = Json::array();
  for (const auto& input : manifest.inputs) {
    inputs.push_back(Json{{"path", input.path}, {"sha1", input.sha1}});
  }
  Json json{{"command", manifest.command},
            {"version", manifest.version},
            {"revision", manifest.revision},
            {"inputs", inputs},
            {"files", manifest.files},
            {"host_time_s", manifest.host_time_s},
            {"processor_time_s", manifest.processor_time_s},
            {"peak_memory_bytes", manifest.peak_memory_bytes}};
  if (!manifest.warnings.empty()) {
    json["warnings"] = manifest.warnings;
  }
  if (manifest.study) {
    json["jobs"] = manifest.study->jobs;
    json["points"] = manifest.study->points;
    json["points_per_s"] = manifest.study->points / manifest.host_time_s;
    json["peak_point_memory_bytes"] = manifest.peak_child_memory_bytes;
  }
  // Arguments may hold bytes that are not UTF-8: they are replaced, not refused.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace maquette::sim
