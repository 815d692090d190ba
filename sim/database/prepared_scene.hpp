#pragma once

#include <memory>
#include <vector>

#include "firmware/conversion.hpp"
#include "firmware/preprocess.hpp"
#include "firmware/synthesize.hpp"
#include "firmware/work_area.hpp"
#include "sim/database/packed_scene.hpp"

namespace maquette::sim {

/// A scene packed and preprocessed: all that the synthesis of its pixels reads. Neither copied nor
/// moved, because the frame points into it.
template <class Real>
class PreparedScene {
 public:
  explicit PreparedScene(PackedScene<Real> packed)
      : packed_(std::move(packed)),
        leaves_(packed_.leaves.size()),
        extents_(packed_.leaves.size() + packed_.composites.size()),
        surfaces_(packed_.surfaces.size()),
        light_positions_(packed_.lights.size()),
        light_axes_(packed_.light_shapes.size()) {
    frame_.database = packed_.database();
    frame_.prepared.leaves = leaves_.data();
    frame_.prepared.extents = extents_.data();
    frame_.prepared.surfaces = surfaces_.data();
    frame_.prepared.light_positions = light_positions_.data();
    frame_.prepared.light_axes = light_axes_.data();
    conversion_ = {packed_.given.data(), static_cast<std::uint32_t>(packed_.given.size()),
                   packed_.parameters.data()};
    if (conversion_.given_count > 0) {
      firmware::convert(frame_.database, conversion_);
    }
    firmware::preprocess(frame_.database, frame_.prepared);
  }
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;
  PreparedScene(PreparedScene&&) = delete;
  PreparedScene& operator=(PreparedScene&&) = delete;
  ~PreparedScene() = default;

  [[nodiscard]] const firmware::Frame<Real>& frame() const { return frame_; }
  /// With its parameters as a board converts them, where it does.
  [[nodiscard]] const PackedScene<Real>& packed() const { return packed_; }
  [[nodiscard]] const firmware::Conversion<Real>& conversion() const { return conversion_; }

 private:
  PackedScene<Real> packed_;
  std::vector<firmware::PreparedLeaf<Real>> leaves_;
  std::vector<firmware::Extent<Real>> extents_;
  std::vector<firmware::PreparedSurface<Real>> surfaces_;
  std::vector<firmware::Vector<Real>> light_positions_;
  std::vector<firmware::Vector<Real>> light_axes_;
  firmware::Conversion<Real> conversion_{};
  firmware::Frame<Real> frame_{};
};

/// Space that one ray's crossings with the whole scene may take.
template <class Real>
firmware::CrossingNeeds crossing_needs_of(const firmware::Database<Real>& database) {
  std::vector<firmware::CrossingNeeds> needs;
  needs.reserve(database.node_count());
  for (firmware::NodeIndex node = 0; node < database.leaf_count; ++node) {
    needs.push_back(firmware::crossing_needs_of_leaf(database, database.leaves[node]));
  }
  for (firmware::NodeIndex node = database.leaf_count; node < database.node_count(); ++node) {
    const firmware::Composite& composite = database.composite(node);
    needs.push_back(firmware::combined_crossing_needs(needs[composite.children[0]],
                                                      needs[composite.children[1]]));
  }
  return needs[database.root];
}

/// The work area of one synthesising thread, of the size that the scene needs.
template <class Real>
class SynthesisArea {
 public:
  explicit SynthesisArea(const firmware::Database<Real>& database)
      : crossings_(static_cast<std::size_t>(crossing_needs_of(database).space)),
        rays_(static_cast<std::size_t>(
            firmware::pending_rays_needed(database.ray_depth, database.needs.transparency))) {}

  [[nodiscard]] firmware::WorkArea<Real> view() { return {crossings_.data(), rays_.data()}; }

 private:
  std::vector<firmware::Crossing<Real>> crossings_;
  std::vector<firmware::PendingRay<Real>> rays_;
};

}  // namespace maquette::sim
