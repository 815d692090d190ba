#include "sim/accuracy/outcome_bytes.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace maquette::sim {

namespace {

using Json = nlohmann::json;

std::vector<models::Duration> durations_of(const std::vector<std::int64_t>& counts) {
  return {counts.begin(), counts.end()};
}

std::vector<std::int64_t> counts_of(const std::vector<models::Duration>& durations) {
  std::vector<std::int64_t> counts;
  counts.reserve(durations.size());
  for (const models::Duration duration : durations) {
    counts.push_back(duration.count());
  }
  return counts;
}

Json json_of(const TileTimes& tiles) {
  const models::PixelRectangle& zone = tiles.grid.zone;
  return {{"column0", zone.column0},
          {"row0", zone.row0},
          {"width", zone.width},
          {"height", zone.height},
          {"times", counts_of(tiles.times)}};
}

TileTimes tiles_of(const Json& json) {
  return {{{json.at("column0"), json.at("row0"), json.at("width"), json.at("height")}},
          durations_of(json.at("times"))};
}

}  // namespace

std::string encode_outcome(const LevelOutcome& outcome) {
  Json json = {{"host_time_s", outcome.host_time_s},
               {"width", outcome.picture.width},
               {"height", outcome.picture.height},
               {"pixels", outcome.picture.pixels}};
  if (outcome.simulated) {
    json["frame"] = outcome.simulated->frame.count();
    json["waits"] = counts_of(outcome.simulated->waits);
    json["processor_clocks"] = outcome.simulated->processor_clocks;
  }
  if (outcome.tiles) {
    json["tiles"] = json_of(*outcome.tiles);
  }
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

LevelOutcome decode_outcome(const std::string& bytes) {
  try {
    const Json json = Json::from_cbor(bytes);
    LevelOutcome outcome;
    outcome.host_time_s = json.at("host_time_s");
    outcome.picture = {json.at("width"), json.at("height"), json.at("pixels")};
    if (json.contains("frame")) {
      outcome.simulated = {models::Duration(json.at("frame").get<std::int64_t>()),
                           durations_of(json.at("waits")), json.at("processor_clocks")};
    }
    if (json.contains("tiles")) {
      outcome.tiles = tiles_of(json.at("tiles"));
    }
    return outcome;
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("the outcome of a level is damaged: ") + error.what());
  }
}

}  // namespace maquette::sim
