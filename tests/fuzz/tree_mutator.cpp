#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"

/// Changes documents node by node, which changes of bytes seldom do without breaking them.
namespace {

using maquette::sim::YamlKind;
using maquette::sim::YamlNode;
using Random = std::mt19937;

/// Numbers and texts at which something may end.
constexpr std::array k_sharp{"0",
                             "-0",
                             "-1",
                             "1",
                             "2",
                             "255",
                             "256",
                             "16384",
                             "65535",
                             "65536",
                             "100000",
                             "1000000",
                             "2147483647",
                             "2147483648",
                             "4294967296",
                             "9223372036854775807",
                             "9223372036854775808",
                             "1e-9",
                             "1e9",
                             "1e18",
                             "1e300",
                             "1e-300",
                             "4.9e-324",
                             "1.7976931348623157e308",
                             "0.1",
                             "100",
                             "nan",
                             "inf",
                             "true",
                             "false",
                             ""};

void collect(YamlNode& node, std::vector<YamlNode*>& nodes) {
  nodes.push_back(&node);
  for (YamlNode& item : node.items) {
    collect(item, nodes);
  }
  for (auto& entry : node.entries) {
    collect(entry.value, nodes);
  }
}

std::size_t below(Random& random, std::size_t bound) { return random() % bound; }

/// Puts another number before the unit.
void sharpen(YamlNode& node, Random& random) {
  const std::size_t unit = std::min(node.text.find(' '), node.text.size());
  node.kind = YamlKind::scalar;
  node.items.clear();
  node.entries.clear();
  node.text = k_sharp[below(random, k_sharp.size())] + node.text.substr(unit);
}

void remove_part(YamlNode& node, Random& random) {
  if (!node.items.empty()) {
    node.items.erase(node.items.begin() +
                     static_cast<std::ptrdiff_t>(below(random, node.items.size())));
  } else if (!node.entries.empty()) {
    node.entries.erase(node.entries.begin() +
                       static_cast<std::ptrdiff_t>(below(random, node.entries.size())));
  } else {
    node.text.clear();
  }
}

void add_part(YamlNode& node, const YamlNode& part, Random& random) {
  if (node.kind == YamlKind::sequence) {
    node.items.insert(
        node.items.begin() + static_cast<std::ptrdiff_t>(below(random, node.items.size() + 1)),
        part);
  } else if (node.kind == YamlKind::mapping && !part.entries.empty()) {
    node.entries.push_back(part.entries[below(random, part.entries.size())]);
  } else {
    node = part;
  }
}

void change(YamlNode& tree, Random& random) {
  std::vector<YamlNode*> nodes;
  collect(tree, nodes);
  YamlNode& node = *nodes[below(random, nodes.size())];
  const YamlNode other = *nodes[below(random, nodes.size())];
  switch (below(random, 8)) {
    case 0:
      remove_part(node, random);
      break;
    case 1:
      add_part(node, other, random);
      break;
    case 2:
      node = other;
      break;
    default:
      sharpen(node.entries.empty() && node.items.empty() ? node : *nodes.back(), random);
  }
}

/// The document with some changes; empty where it is none.
std::string changed(const std::string& text, Random& random) {
  try {
    YamlNode tree = maquette::sim::parse_yaml(text, "input.yaml");
    for (std::size_t changes = 1 + below(random, 3); changes > 0; --changes) {
      change(tree, random);
    }
    return maquette::sim::write_yaml(tree);
  } catch (const maquette::sim::DescriptionError&) {
    return {};
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                        std::size_t most_bytes);

/// What libFuzzer calls in the place of its own changes, one of four of which are still made.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned seed) {
  Random random{seed};
  if (below(random, 4) != 0) {
    const std::string text = changed({reinterpret_cast<const char*>(data), size}, random);
    if (!text.empty() && text.size() <= most_bytes) {
      std::memcpy(data, text.data(), text.size());
      return text.size();
    }
  }
  return LLVMFuzzerMutate(data, size, most_bytes);
}
