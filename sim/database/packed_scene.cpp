#include "sim/database/packed_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <unordered_map>

#include "firmware/arithmetic/counted.hpp"
#include "sim/database/extent_choice.hpp"
#include "sim/database/needs.hpp"
#include "sim/database/observer_packing.hpp"
#include "sim/database/surface_packing.hpp"
#include "sim/database/texture_packing.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"

namespace maquette::sim {

namespace {

template <class Real>
Real rounded(double value) {
  return firmware::constant<Real>(value);
}

template <class Real>
firmware::Vector<Real> rounded(const Vector3& v) {
  return {rounded<Real>(v.x), rounded<Real>(v.y), rounded<Real>(v.z)};
}

template <class Real>
firmware::Affine<Real> rounded(const Placement& placement) {
  firmware::Affine<Real> result;
  for (int column = 0; column < 4; ++column) {
    result[column] = rounded<Real>(placement[column]);
  }
  return result;
}

template <class Real>
firmware::Surface<Real> rounded(const firmware::Surface<double>& s) {
  return {rounded<Real>(s.diffuse),
          rounded<Real>(s.specular),
          s.metal,
          s.transparent,
          s.absorbing,
          s.facets,
          rounded<Real>(s.index),
          rounded<Real>(s.extinction),
          rounded<Real>(s.facet_parameter),
          rounded<Real>(s.facet_scale),
          rounded<Real>(s.absorption)};
}

template <class Real>
firmware::Observer<Real> rounded(const firmware::Observer<double>& observer) {
  return {rounded<Real>(Placement(observer.to_screen)),
          rounded<Real>(Placement(observer.from_screen)),
          rounded<Real>(observer.left),
          rounded<Real>(observer.top),
          rounded<Real>(observer.step),
          observer.columns,
          observer.rows};
}

/// Numbers the surfaces that leaves have, in the order of their declaration.
class UsedSurfaces {
 public:
  UsedSurfaces(const Scene& scene, const ObjectTree& tree) : number_(scene.surfaces.size(), -1) {
    for (const TreeLeaf& leaf : tree.leaves) {
      number_[leaf.surface] = 0;
    }
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (number_[i] == 0) {
        number_[i] = static_cast<int>(packed_.size());
        packed_.push_back(packed_surface(scene.surfaces[i]));
      }
    }
  }

  /// The ambient lights that they have of their own.
  template <class Real>
  [[nodiscard]] std::vector<firmware::Color<Real>> ambients(const Scene& scene) const {
    std::vector<firmware::Color<Real>> ambients(packed_.size());
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (number_[i] >= 0) {
        ambients[static_cast<std::size_t>(number_[i])] =
            rounded<Real>(scene.surfaces[i].ambient.value_or(Color(0, 0, 0)));
      }
    }
    return ambients;
  }

  [[nodiscard]] firmware::SurfaceIndex number_of(std::size_t surface) const {
    return static_cast<firmware::SurfaceIndex>(number_[surface]);
  }
  [[nodiscard]] const std::vector<firmware::Surface<double>>& packed() const { return packed_; }

 private:
  std::vector<int> number_;
  std::vector<firmware::Surface<double>> packed_;
};

/// Puts parameters of a leaf behind others, with the tolerance of its roots.
template <class Real>
void append(const std::vector<double>& parameters, const TreeLeaf& leaf, const Scene& scene,
            std::vector<Real>& packed) {
  const std::size_t first = packed.size();
  for (const double parameter : parameters) {
    packed.push_back(rounded<Real>(parameter));
  }
  const int tolerance = description_of(leaf.kind).root_tolerance;
  if (tolerance != PrimitiveDescription::k_no_tolerance) {
    packed[first + static_cast<std::size_t>(tolerance)] = rounded<Real>(scene.roots.tolerance);
  }
}

template <class Real>
void pack_leaves(const Scene& scene, const ObjectTree& tree, const UsedSurfaces& surfaces,
                 PackedScene<Real>& packed) {
  const bool converts = std::any_of(tree.leaves.begin(), tree.leaves.end(),
                                    [](const TreeLeaf& leaf) { return !leaf.given.empty(); });
  for (const TreeLeaf& leaf : tree.leaves) {
    packed.leaves.push_back({leaf.parent, leaf.kind, surfaces.number_of(leaf.surface),
                             static_cast<std::uint32_t>(packed.parameters.size()),
                             rounded<Real>(leaf.to_scene),
                             rounded<Real>(inverse_of(leaf.to_scene))});
    append(leaf.parameters, leaf, scene, packed.parameters);
    if (converts) {
      append(leaf.given.empty() ? leaf.parameters : leaf.given, leaf, scene, packed.given);
    }
  }
}

/// A point in the frame of a light, in that of the scene.
Vector3 placed(const Light& light, const Vector3& point) {
  return light.placement ? *light.placement * glm::dvec4(point, 1) : point;
}

firmware::LightShape<double> shape_of(const Light& light) {
  constexpr double k_radians = firmware::elementary::k_pi / 180;
  firmware::LightShape<double> shape{};
  shape.reference_squared = light.falloff ? *light.falloff * *light.falloff : 0;
  shape.axis = {0, 0, 0};
  if (light.spot) {
    shape.axis = glm::normalize(placed(light, light.spot->target) - placed(light, light.position));
    const double whole = std::cos(light.spot->angle_deg * k_radians);
    shape.edge_cosine = std::cos((light.spot->angle_deg + light.spot->edge_deg) * k_radians);
    shape.per_cosine = 1 / (whole - shape.edge_cosine);
  }
  return shape;
}

template <class Real>
void pack_lights(const std::vector<Light>& lights, PackedScene<Real>& packed) {
  for (const Light& light : lights) {
    packed.lights.push_back(
        {rounded<Real>(placed(light, light.position)), rounded<Real>(light.intensity)});
    const firmware::LightShape<double> shape = shape_of(light);
    packed.light_shapes.push_back({rounded<Real>(shape.reference_squared),
                                   rounded<Real>(shape.axis), rounded<Real>(shape.edge_cosine),
                                   rounded<Real>(shape.per_cosine)});
  }
}

template <class Real>
void pack_textures(const PackedTextures& textures, PackedScene<Real>& packed) {
  for (const firmware::Texture<double>& texture : textures.textures) {
    packed.textures.push_back({rounded<Real>(Placement(texture.from_leaf)),
                               {rounded<Real>(texture.colors[0]), rounded<Real>(texture.colors[1])},
                               rounded<Real>(texture.columns_per_turn),
                               rounded<Real>(texture.rows_per_turn),
                               texture.first_texel,
                               texture.columns,
                               texture.rows,
                               texture.kind});
  }
  packed.leaf_textures = textures.of_leaves;
  packed.texels = textures.texels;
}

}  // namespace

template <class Real>
PackedScene<Real> packed_scene(const Scene& scene, const PictureFormat& format) {
  const ObjectTree tree = object_tree_of(scene);
  const UsedSurfaces surfaces(scene, tree);
  PackedScene<Real> packed;
  pack_leaves(scene, tree, surfaces, packed);
  packed.composites = tree.composites;
  packed.tree_height = tree.height;
  for (const firmware::Surface<double>& surface : surfaces.packed()) {
    packed.surfaces.push_back(rounded<Real>(surface));
  }
  pack_lights(scene.lights, packed);
  pack_textures(packed_textures(scene, tree), packed);
  firmware::Database<Real>& header = packed.header;
  header.leaf_count = static_cast<firmware::NodeIndex>(packed.leaves.size());
  header.composite_count = static_cast<firmware::NodeIndex>(packed.composites.size());
  header.parameter_count = static_cast<std::uint32_t>(packed.parameters.size());
  header.surface_count = static_cast<firmware::SurfaceIndex>(packed.surfaces.size());
  header.light_count = static_cast<std::uint16_t>(packed.lights.size());
  header.root = tree.root;
  header.observer = rounded<Real>(observer_of(scene.view, format));
  header.ambient = rounded<Real>(scene.ambient);
  header.background = rounded<Real>(scene.background);
  header.ray_depth = scene.ray_tree.depth;
  header.minimum_weight = rounded<Real>(scene.ray_tree.minimum_weight);
  header.texture_count = static_cast<std::uint16_t>(packed.textures.size());
  header.texel_count = static_cast<std::uint32_t>(packed.texels.size() / firmware::k_texel_bytes);
  const Samples samples = scene.samples.value_or(Samples{});
  header.samples = {samples.per_side, rounded<Real>(samples.contrast)};
  header.needs = needs_of(scene, tree, surfaces.packed());
  header.needs.depth = format.has_depth;
  if (header.needs.surface_ambient) {
    packed.surface_ambients = surfaces.ambients<Real>(scene);
  }
  if (!header.needs.shaped_lights) {
    packed.light_shapes.clear();
  }
  packed.extents = scene.extents.value_or(Extents::all);
  packed.leaves_below = leaves_below(tree);
  choose_extents(packed.extents, header);
  return packed;
}

template PackedScene<float> packed_scene<float>(const Scene& scene, const PictureFormat& format);
template PackedScene<double> packed_scene<double>(const Scene& scene, const PictureFormat& format);
template PackedScene<firmware::Counted> packed_scene<firmware::Counted>(
    const Scene& scene, const PictureFormat& format);

}  // namespace maquette::sim
