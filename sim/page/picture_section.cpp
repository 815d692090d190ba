#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/page/data_url.hpp"
#include "sim/page/layers.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"

namespace maquette::sim {
namespace {

using Json = nlohmann::ordered_json;

std::string data_of(const RunResults& results) {
  const FrameStatistics& frame = results.statistics.frame;
  const UsefulZone& zone = results.statistics.useful_zone;
  const Json json = {{"width", frame.width},
                     {"height", frame.height},
                     {"zone",
                      {{"column", zone.column},
                       {"row", zone.row},
                       {"width", zone.width},
                       {"height", zone.height}}},
                     {"layers", layers_of(results.maps)}};
  return json.dump();
}

Html image(const std::string& png, const std::string& description, int width, int height) {
  return void_element("img", {{"alt", description},
                              {"width", std::to_string(width)},
                              {"height", std::to_string(height)},
                              {"src", data_url("image/png", png)}});
}

/// The snapshots side by side, in the order of their instants.
Html film_strip(const RunResults& results) {
  Html strip;
  for (const NamedContent& file : results.snapshots) {
    const std::string name = file.name.substr(0, file.name.rfind(".png"));
    strip += element("figure", image(file.content, name, results.statistics.frame.width,
                                     results.statistics.frame.height) +
                                   element("figcaption", name));
  }
  return results.snapshots.empty()
             ? Html{}
             : element("h3", "Snapshots") + element("div", {{"class", "strip"}}, strip);
}

}  // namespace

Html picture_section(const RunResults& results) {
  const FrameStatistics& frame = results.statistics.frame;
  const Html screen =
      element("div", {{"class", "screen"}},
              image(results.frame_png,
                    fmt::format("The picture of {}, {} x {} pixels", results.description.scene.name,
                                frame.width, frame.height),
                    frame.width, frame.height));
  return element("figure", {{"id", "probe"}, {"class", "picture"}},
                 screen + element("figcaption", "The frame memory at the end of the frame.") +
                     data_element("probe-data", data_of(results))) +
         film_strip(results);
}

}  // namespace maquette::sim
