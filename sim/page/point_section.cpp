#include "sim/page/point_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/page/data_url.hpp"
#include "sim/page/run_files.hpp"
#include "sim/page/run_page.hpp"
#include "sim/report/run_directory.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_prefix = "point-";
/// POINT stands for the number of a point.
constexpr const char* k_command =
    "maquette run --sweep study.yaml --point POINT --outdir point-POINT --report";

/// A point that was run again in a folder of the sweep.
struct KeptRun {
  int point = 0;
  fs::path directory;
};

std::vector<KeptRun> kept_runs(const fs::path& directory) {
  std::vector<KeptRun> runs;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    const std::string number = name.substr(std::min(name.size(), k_prefix.size()));
    const bool is_number = !number.empty() && number.size() < 8 &&
                           number.find_first_not_of("0123456789") == std::string::npos;
    if (name.rfind(k_prefix, 0) == 0 && is_number && fs::exists(entry.path() / "manifest.json")) {
      runs.push_back({std::stoi(number), entry.path()});
    }
  }
  std::sort(runs.begin(), runs.end(),
            [](const KeptRun& first, const KeptRun& second) { return first.point < second.point; });
  return runs;
}

/// What the sweep has of a point against what the run has found, in words.
std::string told_agreement(const fs::path& point_file, const std::string& statistics) {
  std::error_code error;
  if (!fs::exists(point_file, error)) {
    return "the sweep has not run this point yet";
  }
  const nlohmann::json point = nlohmann::json::parse(read_file(point_file), nullptr, false);
  const nlohmann::json run = nlohmann::json::parse(statistics, nullptr, false);
  return point.is_object() && point.value("statistics", nlohmann::json()) == run
             ? "its statistics are those of the sweep"
             : "ITS STATISTICS DIFFER from those of the sweep";
}

Html kept_element(const fs::path& directory, const KeptRun& run) {
  const RunFiles files = read_run_files(run.directory);
  const std::string name = run.directory.filename().string();
  const std::string title = fmt::format("Point {} as a run of its own", run.point);
  const fs::path point_file = directory / "points" / fmt::format("{:06}.json", run.point);
  Html caption = text(title + "; " + told_agreement(point_file, files.content("stats.json")) + ".");
  if (fs::exists(run.directory / k_page_name)) {
    caption += text(" ") + element("a", {{"href", name + "/" + k_page_name}}, text("Its page"));
  }
  return element(
      "figure", {{"class", "kept"}, {"data-point", std::to_string(run.point)}},
      void_element("img",
                   {{"alt", title}, {"src", data_url("image/png", files.content("frame.png"))}}) +
          element("figcaption", caption) +
          folded("Its effective configuration", element("pre", files.content("config.yaml"))));
}

}  // namespace

Html point_section(const fs::path& directory) {
  Html content = paragraph(
      "A point is the description below with the values of its row. Each runs again as a run of "
      "its "
      "own, to the same statistics, with its picture and its effective configuration; a report "
      "that "
      "is made after it shows them here. In the directory of the sweep:");
  std::string example = k_command;
  for (std::size_t at = example.find("POINT"); at != std::string::npos;
       at = example.find("POINT")) {
    example.replace(at, 5, "0");
  }
  content += element("pre", {{"class", "command"}}, text(example));
  for (const KeptRun& run : kept_runs(directory)) {
    content += kept_element(directory, run);
  }
  std::error_code error;
  if (const fs::path study = directory / "study.yaml"; fs::exists(study, error)) {
    content += folded("What is swept around, study.yaml", element("pre", read_file(study)));
  }
  return element("div", {{"id", "chosen-point"}, {"data-command", k_command}}, content);
}

}  // namespace maquette::sim
