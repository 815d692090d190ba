#include "sim/page/sequence_page.hpp"

#include <fmt/format.h>

#include <map>
#include <system_error>
#include <vector>

#include "sim/page/chart.hpp"
#include "sim/page/data_url.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page.hpp"
#include "sim/page/page_table.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/report/compare.hpp"
#include "sim/report/flat_yaml.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

/// A frame that is done.
struct Frame {
  std::string png;
  Statistics statistics;
  models::Duration shown{};  ///< from the beginning of the sequence until it is whole
};

std::vector<Frame> read_frames(const fs::path& folder) {
  std::vector<Frame> frames;
  models::Duration time{};
  std::error_code error;
  for (int i = 0;; ++i) {
    const fs::path statistics = folder / fmt::format("stats-{:04}.json", i);
    const fs::path picture = folder / fmt::format("frame-{:04}.png", i);
    if (!fs::exists(statistics, error) || !fs::exists(picture, error)) {
      return frames;
    }
    Frame frame{read_file(picture), parse_statistics(read_file(statistics), statistics.string())};
    time += frame.statistics.frame.load + frame.statistics.frame.time;
    frame.shown = time;
    frames.push_back(std::move(frame));
  }
}

Description described(const fs::path& folder, const std::string& data_directory) {
  const fs::path file = folder / "config.yaml";
  DescriptionSources sources;
  sources.scene_file = file.string();
  sources.data_directory = data_directory;
  sources.known = {{file.string(), read_file(file)}};
  return load_description(sources);
}

Html film_strip(const std::vector<Frame>& frames) {
  Html strip;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameStatistics& frame = frames[i].statistics.frame;
    const std::string name = fmt::format("frame {}", i);
    strip += element("figure",
                     void_element("img", {{"alt", name},
                                          {"width", std::to_string(frame.width)},
                                          {"height", std::to_string(frame.height)},
                                          {"src", data_url("image/png", frames[i].png)}}) +
                         element("figcaption", fmt::format("{}: takes {}, whole after {}", name,
                                                           readable_duration(frame.time),
                                                           readable_duration(frames[i].shown))));
  }
  return element(
      "div", {{"class", "strip"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", "Frames"}},
      strip);
}

/// How much of the picture is another one than that of the frame before.
std::string told_change(const Frame& before, const Frame& frame) {
  const PictureDifference difference =
      compare_pictures(decode_png(before.png, "frame"), decode_png(frame.png, "frame"));
  const auto pixels = static_cast<double>(frame.statistics.frame.pixels_total);
  return percent(share_of(static_cast<double>(difference.pixels), pixels));
}

Html times_table(const std::vector<Frame>& frames) {
  PageTable table{"Times of the frames",
                  {{"frame"},
                   {"loading s", true},
                   {"of the first loading", true},
                   {"preprocessing s", true},
                   {"frame time s", true},
                   {"whole after s", true},
                   {"pixels changed", true}},
                  {}};
  const double first_load = in_seconds(frames.front().statistics.frame.load);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameStatistics& frame = frames[i].statistics.frame;
    table.rows.push_back({std::to_string(i), fmt::format("{:.6f}", in_seconds(frame.load)),
                          percent(share_of(in_seconds(frame.load), first_load)),
                          four_decimals(frame.preprocess), four_decimals(frame.time),
                          four_decimals(frames[i].shown),
                          i == 0 ? "" : told_change(frames[i - 1], frames[i])});
  }
  return table_element(table);
}

Html times_chart(const std::vector<Frame>& frames) {
  Chart chart{"frames-chart", "Time of each frame", "The table below has it.", ChartKind::columns,
              "frame",        "s of the machine"};
  chart.series.push_back({"preprocessing", {}, {}});
  chart.series.push_back({"synthesis", {}, {}});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameStatistics& frame = frames[i].statistics.frame;
    chart.labels.push_back(std::to_string(i));
    chart.series[0].values.push_back(in_seconds(frame.preprocess));
    chart.series[1].values.push_back(in_seconds(frame.synthesis));
  }
  return chart_element(chart);
}

/// The parameters of the scene that a frame has other than the frame before, with both values.
Html changes_table(const std::vector<Scene>& scenes, std::size_t count) {
  PageTable table{"What each frame has other than the one before: the host loads the words of it",
                  {{"frame"}, {"parameter"}, {"before"}, {"now"}},
                  {}};
  std::map<std::string, std::string> before;
  for (std::size_t i = 0; i < std::min(count, scenes.size()); ++i) {
    for (const auto& [path, value] : flatten_yaml(write_yaml(write_scene(scenes[i])), "scene")) {
      const auto known = before.find(path);
      if (known != before.end() && known->second != value) {
        table.rows.push_back({std::to_string(i), path, known->second, value});
      }
      before[path] = value;
    }
  }
  return table.rows.empty() ? paragraph("The frames are alike.") : table_element(table);
}

}  // namespace

std::string sequence_page(const fs::path& folder, const std::string& name,
                          const std::string& data_directory) {
  const std::vector<Frame> frames = read_frames(folder);
  if (frames.empty()) {
    throw DescriptionError(folder.string() +
                           ": holds no frame of its sequence; allowed: a directory that `maquette "
                           "run` has written");
  }
  const Description description = described(folder, data_directory);
  const std::string told = fmt::format(
      "{} of {} frames on {}, {} of the machine's time.", frames.size(), description.frames.size(),
      description.machine.name, readable_duration(frames.back().shown));
  return page(name + ": a sequence",
              {{"film", "Film strip", paragraph(told) + film_strip(frames)},
               {"times", "Times", times_chart(frames) + times_table(frames)},
               {"loading", "What is loaded anew", changes_table(description.frames, frames.size())},
               {"configuration", "Configuration",
                folded("The scene with its sequence, and the machine",
                       element("pre", read_file(folder / "config.yaml")))}});
}

}  // namespace maquette::sim
