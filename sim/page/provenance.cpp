#include "sim/page/provenance.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/report/flat_json.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

/// "/elsewhere/photo4" becomes "photo4", "a=/b/c" becomes "a=c".
std::string without_place(const std::string& argument) {
  const std::size_t value = argument.find('=') + 1;
  const std::filesystem::path path(argument.substr(value));
  if (!path.is_absolute()) {
    return argument;
  }
  const auto normal = path.lexically_normal();
  const auto last = normal.has_filename() ? normal.filename() : normal.parent_path().filename();
  return argument.substr(0, value) + last.string();
}

std::string quoted(const std::string& argument) {
  constexpr const char* k_plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.,=/:@+%";
  if (!argument.empty() && argument.find_first_not_of(k_plain) == std::string::npos) {
    return argument;
  }
  std::string text = "'";
  for (const char byte : argument) {
    text += byte == '\'' ? std::string("'\\''") : std::string(1, byte);
  }
  return text + "'";
}

}  // namespace

Provenance parse_provenance(const std::string& json, const std::string& name) {
  // What is not JSON is answered with its place.
  flatten_json(json, name);
  try {
    const nlohmann::json manifest = nlohmann::json::parse(json);
    Provenance provenance{manifest.at("command").get<std::vector<std::string>>(),
                          manifest.at("version").get<std::string>(),
                          manifest.at("revision").get<std::string>(),
                          {},
                          manifest.at("files").get<std::vector<std::string>>()};
    for (const nlohmann::json& input : manifest.at("inputs")) {
      provenance.inputs.push_back({without_place(input.at("path").get<std::string>()),
                                   input.at("sha1").get<std::string>()});
    }
    return provenance;
  } catch (const nlohmann::json::exception& error) {
    throw DescriptionError(SourcePosition{name, 1, 1},
                           std::string("is no manifest of results: ") + error.what() +
                               "; allowed: one that maquette has written");
  }
}

std::string command_line(const Provenance& provenance) {
  std::string line;
  for (const std::string& argument : provenance.command) {
    line += (line.empty() ? "" : " ") + quoted(without_place(argument));
  }
  return line;
}

}  // namespace maquette::sim
