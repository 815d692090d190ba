#include "sim/scene/sequence.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/fields/decimal.hpp"
#include "sim/fields/field_reader.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/override.hpp"

namespace maquette::sim {

namespace {

[[noreturn]] void fail(const YamlNode& node, const std::string& message) {
  throw DescriptionError(node.place.position(), message);
}

/// A number and what is written behind it.
struct Measure {
  double number;
  std::string unit;
};

Measure measure_of(const YamlNode& node) {
  if (node.kind == YamlKind::scalar) {
    std::string_view rest = node.text;
    const std::optional<Decimal> decimal = take_decimal(rest);
    const std::optional<double> number = decimal ? to_double(*decimal) : std::nullopt;
    if (number) {
      return {*number, std::string{rest}};
    }
  }
  fail(
      node,
      "values from one to another are numbers, of one unit, or lists of numbers; a list of a value "
      "for each frame is allowed as well");
}

YamlNode between(const YamlNode& from, const YamlNode& to, double share) {
  if (from.kind == YamlKind::sequence) {
    if (to.kind != YamlKind::sequence || to.items.size() != from.items.size()) {
      fail(to, "as many numbers as where it comes from are allowed");
    }
    std::vector<YamlNode> items;
    for (std::size_t i = 0; i < from.items.size(); ++i) {
      items.push_back(between(from.items[i], to.items[i], share));
    }
    YamlNode list = yaml_sequence(std::move(items));
    list.place = from.place;
    return list;
  }
  const Measure first = measure_of(from);
  const Measure last = measure_of(to);
  if (first.unit != last.unit) {
    fail(to, "the unit of where it comes from, `" + first.unit + "`, is allowed");
  }
  YamlNode value = yaml_scalar(
      to_text(to_decimal(first.number + (last.number - first.number) * share)) + first.unit);
  value.place = from.place;
  return value;
}

std::vector<YamlNode> values_of(const YamlNode& node, int frames) {
  if (node.kind == YamlKind::sequence) {
    if (node.items.size() != static_cast<std::size_t>(frames)) {
      fail(node, "sequence: " + std::to_string(node.items.size()) + " values, but " +
                     std::to_string(frames) + " frames; one for each frame is allowed");
    }
    return node.items;
  }
  check_mapping(node, "sequence");
  check_keys(node, "sequence", {"from", "to"});
  const YamlNode* from = node.find("from");
  const YamlNode* to = node.find("to");
  if (from == nullptr || to == nullptr) {
    fail(node, "sequence: a list of a value for each frame, or {from: A, to: B} is allowed");
  }
  std::vector<YamlNode> values;
  values.reserve(static_cast<std::size_t>(frames));
  for (int frame = 0; frame < frames; ++frame) {
    values.push_back(between(*from, *to, frames == 1 ? 0 : 1.0 * frame / (frames - 1)));
  }
  return values;
}

}  // namespace

Sequence SequenceType::read(const YamlNode& node, std::string_view name) {
  check_mapping(node, name);
  check_keys(node, name, {"frames", "vary"});
  const YamlNode* frames = node.find("frames");
  const YamlNode* vary = node.find("vary");
  if (frames == nullptr || vary == nullptr) {
    fail(node, std::string{name} + ": it needs frames and vary");
  }
  Sequence sequence;
  const WholeType count{WholeDimension::count, {1, k_most_frames}};
  sequence.frames = static_cast<int>(count.read(*frames, "frames"));
  check_mapping(*vary, "vary");
  for (const YamlEntry& entry : vary->entries) {
    const std::string first = parse_path(entry.key, entry.place).front().key;
    if (first == "machine" || first == "sequence") {
      throw DescriptionError(entry.place.position(),
                             "sequence: `" + first +
                                 "` is the same for all frames; a path to another parameter of the "
                                 "scene is allowed");
    }
    sequence.tracks.push_back({entry.key, values_of(entry.value, sequence.frames)});
  }
  return sequence;
}

YamlNode SequenceType::write(const Sequence& sequence) {
  YamlNode vary = yaml_mapping();
  for (const SequenceTrack& track : sequence.tracks) {
    append(vary, track.path, yaml_sequence(track.values));
  }
  YamlNode node = yaml_mapping();
  append(node, "frames", yaml_scalar(std::to_string(sequence.frames)));
  append(node, "vary", std::move(vary));
  return node;
}

YamlNode frame_of(const YamlNode& scene, const Sequence& sequence, int frame) {
  YamlNode tree = scene;
  const auto own = std::find_if(tree.entries.begin(), tree.entries.end(),
                                [](const YamlEntry& entry) { return entry.key == "sequence"; });
  if (own != tree.entries.end()) {
    tree.entries.erase(own);
  }
  for (const SequenceTrack& track : sequence.tracks) {
    const YamlNode& value = track.values.at(static_cast<std::size_t>(frame));
    apply_override(tree, {parse_path(track.path, value.place), value});
  }
  return tree;
}

}  // namespace maquette::sim
