#include "tests/fuzz/descriptions.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/fuzz/harness.hpp"

namespace maquette::fuzz {

namespace fs = std::filesystem;

sim::YamlNode read_tree(const std::string& input) {
  sim::YamlNode tree = sim::parse_yaml(input, "input.yaml");
  const std::string written = sim::write_yaml(tree);
  require(sim::write_yaml(sim::parse_yaml(written, "written.yaml")) == written,
          "a document that was written reads back as another one");
  return tree;
}

std::vector<std::string> texts_below(const std::string& folder, std::size_t most_bytes) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator{fs::path{MAQUETTE_PROJECT_DIRECTORY} / folder}) {
    if (entry.path().extension() == ".yaml" && entry.file_size() <= most_bytes) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const fs::path& file : files) {
    std::ifstream stream{file, std::ios::binary};
    texts.emplace_back(std::istreambuf_iterator<char>{stream}, std::istreambuf_iterator<char>{});
  }
  return texts;
}

}  // namespace maquette::fuzz
