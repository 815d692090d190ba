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

}  // namespace

std::string encode_outcome(const LevelOutcome& outcome) {
  Json json = {{"host_time_s", outcome.host_time_s},
               {"width", outcome.picture.width},
               {"height", outcome.picture.height},
               {"pixels", outcome.picture.pixels}};
  if (outcome.simulated) {
    std::vector<std::int64_t> waits;
    for (const models::Duration wait : outcome.simulated->waits) {
      waits.push_back(wait.count());
    }
    json["frame"] = outcome.simulated->frame.count();
    json["waits"] = waits;
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
                           durations_of(json.at("waits"))};
    }
    return outcome;
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("the outcome of a level is damaged: ") + error.what());
  }
}

}  // namespace maquette::sim
