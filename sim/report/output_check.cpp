#include "sim/report/output_check.hpp"

#include <algorithm>
#include <system_error>

#include "sim/report/replaceable.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

/// One path for all ways to write it, as far as the directories on it are there.
fs::path plain(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::absolute(path).lexically_normal() : result;
}

[[noreturn]] void refuse(const RequestedOutput& output, const std::string& reason) {
  throw DescriptionError(SourcePosition{output.option + " " + output.path.string(), 1, 1},
                         reason + "; another file is allowed");
}

/// Results have names of their own; a folder that a run keeps is not among them.
bool is_result(const fs::path& name) {
  const std::string text = name.string();
  const auto begins = [&text](const char* start) { return text.rfind(start, 0) == 0; };
  return text == "stats.json" || text == "config.yaml" || text == "manifest.json" ||
         text == "sequence.json" || text == "depth.png" || text == "frame.png" ||
         text == "ram.map" || begins("frame-") || begins("snapshot-") || begins("ram-") ||
         begins("map-") || text == "maps.exr";
}

}  // namespace

void check_outputs(const std::vector<RequestedOutput>& outputs,
                   const std::vector<InputFile>& inputs, const fs::path& results) {
  std::vector<fs::path> others;
  for (const RequestedOutput& output : outputs) {
    replaceable(output.path);
    const fs::path place = plain(output.path);
    if (std::any_of(inputs.begin(), inputs.end(),
                    [&place](const InputFile& input) { return plain(input.path) == place; })) {
      refuse(output, "the command reads this file");
    }
    if (std::find(others.begin(), others.end(), place) != others.end()) {
      refuse(output, "this file is written twice");
    }
    if (place.parent_path() == plain(results) && is_result(place.filename())) {
      refuse(output, "a result of the run has this name");
    }
    others.push_back(place);
  }
}

}  // namespace maquette::sim
