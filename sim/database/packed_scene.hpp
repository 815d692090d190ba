#pragma once

#include <cstdint>
#include <vector>

#include "firmware/conversion.hpp"
#include "firmware/database.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/database/picture_format.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Owns the arrays of a firmware database.
template <class Real>
struct PackedScene {
  std::vector<firmware::Leaf<Real>> leaves;
  std::vector<firmware::Composite> composites;
  std::vector<Real> parameters;
  /// What boards convert to the parameters, of all leaves; empty where nothing is converted.
  std::vector<Real> given;
  std::vector<firmware::Surface<Real>> surfaces;
  std::vector<firmware::Light<Real>> lights;
  std::vector<firmware::Color<Real>> surface_ambients;
  std::vector<firmware::LightShape<Real>> light_shapes;
  std::vector<std::uint16_t> leaf_textures;
  std::vector<firmware::Texture<Real>> textures;
  std::vector<std::uint8_t> texels;
  firmware::Database<Real> header{};  ///< all but the pointers
  int tree_height = 0;
  Extents extents = Extents::all;           ///< where work is counted
  std::vector<std::uint32_t> leaves_below;  ///< by node

  /// The database over these arrays; valid as long as they are neither moved nor changed.
  [[nodiscard]] firmware::Database<Real> database() const {
    firmware::Database<Real> view = header;
    view.leaves = leaves.data();
    view.composites = composites.data();
    view.parameters = parameters.data();
    view.surfaces = surfaces.data();
    view.lights = lights.data();
    view.surface_ambients = surface_ambients.data();
    view.light_shapes = light_shapes.data();
    view.leaf_textures = leaf_textures.data();
    view.textures = textures.data();
    view.texels = texels.data();
    if constexpr (firmware::ExtentUse<Real>::is_chosen) {
      view.leaves_below = leaves_below.data();
    }
    return view;
  }

  /// What of it is loaded; where it goes on a board, a prepared scene knows.
  [[nodiscard]] firmware::Conversion<Real> conversion() const {
    return {given.data(), static_cast<std::uint32_t>(given.size()), nullptr};
  }
};

/// Packs a checked scene as the boards get it: only surfaces that a primitive has, lights only
/// where a surface can show them. All values are computed in double precision and rounded once.
template <class Real>
PackedScene<Real> packed_scene(const Scene& scene, const PictureFormat& format);

}  // namespace maquette::sim
