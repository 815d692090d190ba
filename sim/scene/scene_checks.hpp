#pragma once

#include "sim/scene/scene.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Checks what no single value shows; `node` is what the value was read from. Throws
/// DescriptionError.
void check_view(const View& view, const YamlNode& node);
void check_light(const Light& light, const YamlNode& node);
void check_surface(const Surface& surface, const YamlNode& node);
void check_samples(const Samples& samples, const YamlNode& node);

/// What has no thickness needs an opaque surface, and nothing is cut by it.
void check_sheets(const Scene& scene);
/// Refuses a tree of rays that would hardly end: between transparent bodies each ray is followed by
/// two, as far as depth and weight allow. `node` is that of the scene.
void check_ray_tree(const Scene& scene, const YamlNode& node);

}  // namespace maquette::sim
