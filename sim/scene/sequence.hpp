#pragma once

#include <string>
#include <string_view>

#include "sim/scene/scene.hpp"
#include "sim/yaml/yaml_node.hpp"

/// Sequences: a scene whose parameters have other values in each frame, as objects that are
/// deformed (paper, section IV.1) or an eye that moves.
namespace maquette::sim {

inline constexpr int k_most_frames = 10'000;

/// The type of a scene's sequence: `{frames: N, vary: {PATH: VALUES}}`. Values are a list of N, or
/// `{from: A, to: B}` with numbers, numbers of one unit, or lists of numbers, which go in even
/// steps. Throws DescriptionError.
struct SequenceType {
  [[nodiscard]] static Sequence read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const Sequence& sequence);
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "{frames, vary: {PATH: values}}"; }
};

/// The scene's tree as it is in a frame, from 0, without the sequence. Throws DescriptionError
/// where a path leads nowhere.
[[nodiscard]] YamlNode frame_of(const YamlNode& scene, const Sequence& sequence, int frame);

}  // namespace maquette::sim
