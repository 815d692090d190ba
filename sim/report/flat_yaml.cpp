#include "sim/report/flat_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

void flatten(const YAML::Node& node, const std::string& path, FlatValues& values) {
  if (node.IsMap()) {
    for (const auto& member : node) {
      const std::string prefix = path.empty() ? "" : path + ".";
      flatten(member.second, prefix + member.first.as<std::string>(), values);
    }
  } else if (node.IsSequence()) {
    for (std::size_t i = 0; i < node.size(); ++i) {
      flatten(node[i], path + "[" + std::to_string(i) + "]", values);
    }
  } else {
    values.emplace_back(path, node.IsScalar() ? node.Scalar() : "null");
  }
}

}  // namespace

FlatValues flatten_yaml(const std::string& text, const std::string& name) {
  try {
    FlatValues values;
    flatten(YAML::Load(text), "", values);
    return values;
  } catch (const YAML::Exception& error) {
    throw DescriptionError({name, error.mark.line + 1, error.mark.column + 1},
                           "is not YAML: " + error.msg);
  }
}

}  // namespace maquette::sim
