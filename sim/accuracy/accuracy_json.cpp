#include "sim/accuracy/accuracy_json.hpp"

#include <nlohmann/json.hpp>

#include "sim/accuracy/accuracy_tables.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {

namespace {

using Json = nlohmann::ordered_json;

/// A number as it is written, other texts as such, nothing for an empty cell.
Json value_of(const std::string& cell) {
  if (cell.empty()) {
    return nullptr;
  }
  const Json number = Json::parse(cell, nullptr, false);
  return number.is_number() ? number : Json(cell);
}

Json object_of(const Table& table, std::size_t row) {
  Json object = Json::object();
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    object[table.columns[column].name] = value_of(table.rows[row][column]);
  }
  return object;
}

Json boards_of(const LevelResult& level) {
  Json boards = Json::array();
  if (level.simulated && level.error.simulated) {
    for (std::size_t i = 0; i < level.error.simulated->waits.size(); ++i) {
      const TimeError& error = level.error.simulated->waits[i];
      boards.push_back({{"wait_s", in_seconds(level.simulated->waits[i])},
                        {"wait_error_s", in_seconds(error.absolute)},
                        {"wait_error", error.relative ? Json(*error.relative) : Json(nullptr)}});
    }
  }
  return boards;
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string error_json(const std::string& scene, const std::vector<LadderResult>& results) {
  const Table table = error_table(results);
  Json ladders = Json::array();
  std::size_t row = 0;
  for (const LadderResult& result : results) {
    Json levels = Json::array();
    for (const LevelResult& level : result.levels) {
      levels.push_back(object_of(table, row++));
      levels.back()["boards"] = boards_of(level);
    }
    ladders.push_back({{"name", result.ladder.name},
                       {"varies", result.ladder.varies},
                       {"reference", result.ladder.reference_name()},
                       {"levels", levels}});
  }
  return text_of({{"scene", scene}, {"ladders", ladders}});
}

std::string host_time_json(const std::vector<LadderResult>& results) {
  const Table table = host_time_table(results);
  Json levels = Json::array();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    levels.push_back(object_of(table, row));
  }
  return text_of({{"levels", levels}});
}

}  // namespace maquette::sim
