#pragma once

#include <cstring>
#include <vector>

#include "firmware/preprocess.hpp"
#include "firmware/synthesize.hpp"
#include "firmware/work_area.hpp"
#include "tests/firmware/random_cases.hpp"

/// Frames by hand: primitives, operators and surfaces in double precision, rounded once to the
/// number type, as a packed scene is.
namespace maquette::firmware::trial {

inline Surface<double> matt_surface(const Color<double>& diffuse = {1, 1, 1}) {
  Surface<double> surface{};
  surface.diffuse = diffuse;
  surface.index = {1.5, 1.5, 1.5};
  surface.facets = facet_kind_of<cosine_power::Kind>;
  surface.facet_parameter = 50;
  surface.facet_scale = (50 + 2) / 8.0;
  return surface;
}

inline Surface<double> glass_surface(double index, const Color<double>& absorption = {0, 0, 0}) {
  Surface<double> surface = matt_surface();
  surface.specular = 1;
  surface.index = {index, index, index};
  surface.transparent = true;
  surface.absorption = absorption;
  surface.absorbing = absorption != Color<double>(0, 0, 0);
  return surface;
}

inline Surface<double> mirror_surface() {
  Surface<double> surface = matt_surface();
  surface.specular = 1;
  surface.metal = true;
  surface.index = {0.2, 0.9, 1.2};
  surface.extinction = {3.9, 2.5, 2.3};
  return surface;
}

inline Needs all_needs() {
  Needs needs{};
  for (bool& kind : needs.primitives) {
    kind = true;
  }
  needs.several_spans = true;
  needs.unions = needs.intersections = needs.differences = true;
  needs.diffuse = needs.specular = needs.dielectrics = needs.metals = true;
  for (bool& facets : needs.facets) {
    facets = true;
  }
  needs.transparency = needs.absorption = needs.lights = needs.shadows = needs.ambient = true;
  needs.reflections = true;
  return needs;
}

/// A scene under construction. Composites are told from leaves by a high bit until it is built.
struct Model {
  struct Solid {
    PrimitiveKind kind;
    SurfaceIndex surface;
    Placement to_scene;
    std::vector<double> parameters;
  };

  std::vector<Solid> solids;
  std::vector<Composite> composites;
  std::vector<Surface<double>> surfaces{matt_surface()};
  std::vector<Light<double>> lights;
  Placement from_screen = unmoved();
  Color<double> ambient{0, 0, 0};
  Color<double> background{0, 0, 0};
  std::int32_t ray_depth = 4;
  double minimum_weight = 1.0 / 256;
  std::int32_t columns = 64;
  std::int32_t rows = 48;
  double field = 1;  ///< height of the screen one unit in front of the eye
  Needs needs = all_needs();

  static constexpr NodeIndex k_composite = 0x80000000;

  SurfaceIndex add(const Surface<double>& surface) {
    surfaces.push_back(surface);
    return static_cast<SurfaceIndex>(surfaces.size() - 1);
  }
  NodeIndex add(PrimitiveKind kind, const Placement& to_scene, SurfaceIndex surface = 0,
                double parameter = 0) {
    return add(kind, to_scene, surface, std::vector<double>{parameter});
  }
  NodeIndex add(PrimitiveKind kind, const Placement& to_scene, SurfaceIndex surface,
                std::vector<double> parameters) {
    solids.push_back({kind, surface, to_scene, std::move(parameters)});
    return static_cast<NodeIndex>(solids.size() - 1);
  }
  NodeIndex combine(BooleanOperator combination, NodeIndex a, NodeIndex b) {
    composites.push_back({k_no_node, {a, b}, combination});
    return static_cast<NodeIndex>(composites.size() - 1) | k_composite;
  }
};

template <class Real>
Vector<Real> rounded(const Vector<double>& v) {
  return {constant<Real>(v.x), constant<Real>(v.y), constant<Real>(v.z)};
}

template <class Real>
Affine<Real> rounded(const Placement& p) {
  Affine<Real> result;
  for (int column = 0; column < 4; ++column) {
    result[column] = rounded<Real>(p[column]);
  }
  return result;
}

template <class Real>
Surface<Real> rounded(const Surface<double>& s) {
  return {rounded<Real>(s.diffuse),
          constant<Real>(s.specular),
          s.metal,
          s.transparent,
          s.absorbing,
          s.facets,
          rounded<Real>(s.index),
          rounded<Real>(s.extinction),
          constant<Real>(s.facet_parameter),
          constant<Real>(s.facet_scale),
          rounded<Real>(s.absorption)};
}

inline Vector<double> exact(const Vector<float>& v) { return {v.x, v.y, v.z}; }
inline Vector<double> exact(const Vector<double>& v) { return v; }

/// A model with all that the synthesis of its pixels reads and writes.
template <class Real>
class BuiltFrame {
 public:
  BuiltFrame(const Model& model, NodeIndex root) {
    add_nodes(model);
    for (const Surface<double>& surface : model.surfaces) {
      surfaces_.push_back(rounded<Real>(surface));
    }
    for (const Light<double>& light : model.lights) {
      lights_.push_back({rounded<Real>(light.position), rounded<Real>(light.intensity)});
    }
    fill_database(model, root);
    prepare();
    needs_ = crossing_needs();
    crossings_.assign(static_cast<std::size_t>(needs_.space) + k_guards, guard_crossing());
    rays_.resize(
        static_cast<std::size_t>(pending_rays_needed(model.ray_depth, model.needs.transparency)) +
        k_guards);
    std::memset(static_cast<void*>(rays_.data()), k_guard_byte, rays_.size() * sizeof rays_[0]);
  }
  BuiltFrame(const BuiltFrame&) = delete;
  BuiltFrame& operator=(const BuiltFrame&) = delete;

  Frame<Real> frame{};

  [[nodiscard]] NodeIndex root() const { return frame.database.root; }
  [[nodiscard]] const CrossingNeeds& needs() const { return needs_; }
  WorkArea<Real> area() { return {crossings_.data(), rays_.data()}; }

  /// Crossings of a ray of unit direction with the whole tree.
  std::vector<Crossing<Real>> crossings_of(const RayQuery<Real>& query) {
    const std::int32_t count = cross(frame, query, root(), crossings_.data());
    return {crossings_.begin(), crossings_.begin() + count};
  }
  std::vector<Crossing<Real>> crossings_of(const Vector<double>& origin,
                                           const Vector<double>& direction) {
    return crossings_of(
        {{rounded<Real>(origin), rounded<Real>(direction)}, far_away<Real>(), false, 0, 0});
  }

  Pixel pixel(std::int16_t column, std::int16_t row) {
    return synthesize(frame, area(), column, row);
  }

  /// Makes every test of an extent succeed.
  void open_extents() {
    for (Extent<Real>& extent : extents_) {
      extent.bounded = false;
      extent.rectangle = preprocessing::whole_screen(frame.database.observer);
    }
  }

  /// Whether nothing was written behind the work areas.
  [[nodiscard]] bool guards_are_whole() const {
    for (std::size_t i = crossings_.size() - k_guards; i < crossings_.size(); ++i) {
      if (crossings_[i].leaf != k_no_node) {
        return false;
      }
    }
    const auto* bytes =
        reinterpret_cast<const unsigned char*>(rays_.data() + (rays_.size() - k_guards));
    for (std::size_t i = 0; i < k_guards * sizeof rays_[0]; ++i) {
      if (bytes[i] != k_guard_byte) {
        return false;
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t k_guards = 8;
  static constexpr unsigned char k_guard_byte = 0xA5;

  static Crossing<Real> guard_crossing() {
    Crossing<Real> guard{};
    guard.leaf = k_no_node;
    return guard;
  }

  void add_nodes(const Model& model) {
    for (const Model::Solid& solid : model.solids) {
      leaves_.push_back({k_no_node, solid.kind, solid.surface,
                         static_cast<std::uint32_t>(parameters_.size()),
                         rounded<Real>(solid.to_scene), rounded<Real>(inverse(solid.to_scene))});
      for (const double parameter : solid.parameters) {
        parameters_.push_back(constant<Real>(parameter));
      }
    }
    for (const Composite& draft : model.composites) {
      composites_.push_back({k_no_node,
                             {number_of(draft.children[0]), number_of(draft.children[1])},
                             draft.combination});
    }
  }

  [[nodiscard]] NodeIndex number_of(NodeIndex node) const {
    return (node & Model::k_composite) == 0
               ? node
               : static_cast<NodeIndex>(leaves_.size()) + (node & ~Model::k_composite);
  }

  void fill_database(const Model& model, NodeIndex root) {
    Database<Real>& database = frame.database;
    database = {};
    database.leaves = leaves_.data();
    database.composites = composites_.data();
    database.parameters = parameters_.data();
    database.surfaces = surfaces_.data();
    database.lights = lights_.data();
    database.leaf_count = static_cast<NodeIndex>(leaves_.size());
    database.composite_count = static_cast<NodeIndex>(composites_.size());
    database.parameter_count = static_cast<std::uint32_t>(parameters_.size());
    database.surface_count = static_cast<SurfaceIndex>(surfaces_.size());
    database.light_count = static_cast<std::uint16_t>(lights_.size());
    database.root = number_of(root);
    const double step = model.field / model.rows;
    database.observer = {rounded<Real>(inverse(model.from_screen)),
                         rounded<Real>(model.from_screen),
                         constant<Real>(-step * (model.columns - 1) / 2),
                         constant<Real>(step * (model.rows - 1) / 2),
                         constant<Real>(step),
                         model.columns,
                         model.rows};
    database.ambient = rounded<Real>(model.ambient);
    database.background = rounded<Real>(model.background);
    database.ray_depth = model.ray_depth;
    database.minimum_weight = constant<Real>(model.minimum_weight);
    database.needs = model.needs;
    database.needs.reflections = model.needs.reflections && model.ray_depth > 0;
  }

  void prepare() {
    prepared_leaves_.resize(leaves_.size());
    extents_.resize(leaves_.size() + composites_.size());
    prepared_surfaces_.resize(surfaces_.size());
    light_positions_.resize(lights_.size());
    frame.prepared.leaves = prepared_leaves_.data();
    frame.prepared.extents = extents_.data();
    frame.prepared.surfaces = prepared_surfaces_.data();
    frame.prepared.light_positions = light_positions_.data();
    preprocess(frame.database, frame.prepared);
  }

  [[nodiscard]] CrossingNeeds crossing_needs() const {
    std::vector<CrossingNeeds> needs;
    for (const Leaf<Real>& leaf : leaves_) {
      needs.push_back(crossing_needs_of_leaf(frame.database, leaf));
    }
    for (const Composite& composite : composites_) {
      needs.push_back(
          combined_crossing_needs(needs[composite.children[0]], needs[composite.children[1]]));
    }
    return needs[frame.database.root];
  }

  std::vector<Leaf<Real>> leaves_;
  std::vector<Composite> composites_;
  std::vector<Real> parameters_;
  std::vector<Surface<Real>> surfaces_;
  std::vector<Light<Real>> lights_;
  std::vector<PreparedLeaf<Real>> prepared_leaves_;
  std::vector<Extent<Real>> extents_;
  std::vector<PreparedSurface<Real>> prepared_surfaces_;
  std::vector<Vector<Real>> light_positions_;
  CrossingNeeds needs_{};
  std::vector<Crossing<Real>> crossings_;
  std::vector<PendingRay<Real>> rays_;
};

/// A query along a ray of unit direction, as secondary rays are.
template <class Real>
RayQuery<Real> unit_query(const Vector<double>& origin, const Vector<double>& direction) {
  return {{rounded<Real>(origin), rounded<Real>(direction)}, far_away<Real>(), false, 0, 0};
}

}  // namespace maquette::firmware::trial
