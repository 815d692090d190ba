#include "sim/yaml/yaml_writer.hpp"

#include <random>
#include <string>

#include "sim/yaml/yaml_reader.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

std::string random_text(std::mt19937& random) {
  constexpr std::string_view k_letters{"abZ09 _-.:,#{}[]&*!|>'\"%@`?\\/~\n\t\r\x01\x7f\xc3\xa9 =+",
                                       45};
  std::string text;
  for (std::size_t length = random() % 8; length > 0; --length) {
    text += k_letters[random() % k_letters.size()];
  }
  // Half of a letter beyond ASCII is no text; the reader would replace it.
  for (std::size_t at = 0; (at = text.find_first_of("\xc3\xa9", at)) != std::string::npos;) {
    text.replace(at, 1, "\xc3\xa9");
    at += 2;
  }
  return text;
}

YamlNode random_node(std::mt19937& random, int depth) {
  const unsigned kind = depth == 0 ? random() % 2 : random() % 4;
  if (kind == 0) {
    return random() % 4 == 0 ? YamlNode{} : yaml_scalar(random_text(random));
  }
  if (kind == 1) {
    return yaml_scalar(std::to_string(random() % 1000));
  }
  if (kind == 2) {
    std::vector<YamlNode> items;
    for (unsigned count = random() % 4; count > 0; --count) {
      items.push_back(random_node(random, depth - 1));
    }
    return yaml_sequence(std::move(items));
  }
  YamlNode mapping = yaml_mapping();
  for (unsigned count = random() % 4; count > 0; --count) {
    const std::string key = random_text(random) + std::to_string(count);
    append(mapping, key, random_node(random, depth - 1));
  }
  return mapping;
}

bool is_equal(const YamlNode& left, const YamlNode& right) {
  if (left.kind != right.kind || left.text != right.text ||
      left.items.size() != right.items.size() || left.entries.size() != right.entries.size()) {
    return false;
  }
  for (std::size_t i = 0; i < left.items.size(); ++i) {
    if (!is_equal(left.items[i], right.items[i])) {
      return false;
    }
  }
  for (std::size_t i = 0; i < left.entries.size(); ++i) {
    if (left.entries[i].key != right.entries[i].key ||
        !is_equal(left.entries[i].value, right.entries[i].value)) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("any tree is written so that it reads back, in blocks and on one line") {
  std::mt19937 random{7};
  for (int i = 0; i < 5000; ++i) {
    const YamlNode node = random_node(random, 4);
    const std::string block = write_yaml(node);
    const std::string flow = write_flow(node);
    INFO(block);
    INFO(flow);
    REQUIRE(is_equal(parse_yaml(block, "block"), node));
    REQUIRE(is_equal(parse_yaml(flow, "flow"), node));
  }
}

TEST_CASE("the written form is the plain one") {
  YamlNode root = yaml_mapping();
  append(root, "clock", yaml_scalar("8 MHz"));
  append(root, "eye", yaml_sequence({yaml_scalar("4"), yaml_scalar("-6"), yaml_scalar("0.5")}));
  YamlNode child = yaml_mapping();
  append(child, "sphere", yaml_mapping());
  append(root, "union", yaml_sequence({child, child}));
  append(root, "note", yaml_scalar("a: b"));
  CHECK(write_yaml(root) ==
        "clock: 8 MHz\n"
        "eye: [4, -6, 0.5]\n"
        "union:\n"
        "  - sphere: {}\n"
        "  - sphere: {}\n"
        "note: \"a: b\"\n");
}

}  // namespace maquette::sim
