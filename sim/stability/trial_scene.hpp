#pragma once

#include <vector>

#include "firmware/ray_tree.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Crossings of a ray, owned by the trial scene that found them.
template <class Real>
struct Crossings {
  const firmware::Crossing<Real>* first;
  std::int32_t count;

  [[nodiscard]] const firmware::Crossing<Real>* begin() const { return first; }
  [[nodiscard]] const firmware::Crossing<Real>* end() const { return first + count; }
};

/// The surfaces of trial objects: two opaque ones, a transparent one.
inline constexpr const char* k_trial_surfaces[] = {"stone", "chalk", "glass"};

/// A scene of one object that stands in the screen frame as its placement says, with the trial
/// surfaces, no light, and the eye at the origin.
[[nodiscard]] Scene scene_of(Object object);

/// A scene packed for one number type, and room for the crossings of one ray.
template <class Real>
class TrialScene {
 public:
  explicit TrialScene(const Scene& scene)
      : prepared_(packed_scene<Real>(scene, {64, 48})), area_(prepared_.frame().database) {}

  [[nodiscard]] const firmware::Frame<Real>& frame() const { return prepared_.frame(); }

  /// Valid until the next call.
  [[nodiscard]] Crossings<Real> crossings(const firmware::RayQuery<Real>& query) {
    firmware::Crossing<Real>* first = area_.view().crossings;
    return {first, firmware::cross(frame(), query, frame().database.root, first)};
  }

  /// The medium at a distance along a ray.
  [[nodiscard]] firmware::SurfaceIndex medium(const firmware::RayQuery<Real>& query,
                                              Real distance) {
    firmware::SurfaceIndex medium = firmware::k_void;
    for (const firmware::Crossing<Real>& crossing : crossings(query)) {
      medium = crossing.distance > distance ? medium : crossing.medium;
    }
    return medium;
  }

 private:
  PreparedScene<Real> prepared_;
  SynthesisArea<Real> area_;
};

template <class Real>
[[nodiscard]] firmware::Vector<Real> rounded(const Vector3& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

/// A ray of unit direction, as secondary rays are.
template <class Real>
[[nodiscard]] firmware::RayQuery<Real> query_of(const firmware::Vector<Real>& origin,
                                                const Vector3& direction) {
  return {{origin, rounded<Real>(direction)}, firmware::far_away<Real>(), false, 0, 0};
}

}  // namespace maquette::sim
