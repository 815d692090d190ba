#include "tools/benchmark/peer_scenes.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "sim/primitives/cylinder.hpp"
#include "sim/primitives/sphere.hpp"
#include "sim/primitives/torus.hpp"

namespace maquette::benchmark {

namespace {

template <class Shape>
void add(sim::Scene& scene, Shape shape, const char* surface, const sim::Placement& placement) {
  sim::Object body;
  body.primitive = sim::primitive_of(std::move(shape));
  body.surface = surface;
  body.placement = placement;
  scene.object.children.push_back(std::move(body));
}

sim::Placement at(double x, double y, double z) {
  sim::Placement placement(1.0);
  placement[3] = {x, y, z};
  return placement;
}

/// By turns, as a chessboard has its squares.
void add_grid(sim::Scene& scene) {
  constexpr int k_columns = 20;
  constexpr int k_rows = 10;
  constexpr double k_step = 0.8;
  constexpr double k_radius = 0.28;
  for (int row = 0; row < k_rows; ++row) {
    for (int column = 0; column < k_columns; ++column) {
      const double x = k_step * (column - (k_columns - 1) / 2.0);
      const double y = 2 * k_step * (row - (k_rows - 1) / 2.0);
      if ((row + column) % 2 == 0) {
        add(scene, sim::SphereShape{sim::Vector3(k_radius)}, "sphere", at(x, y, k_radius));
      } else {
        sim::CylinderShape cylinder;
        cylinder.radius = k_radius;
        cylinder.axis.height = 2 * k_radius;
        add(scene, cylinder, "cylinder", at(x, y, 0));
      }
    }
  }
}

/// Each reflects a quarter, as a metal that absorbs nearly nothing.
void add_reflecting_grid(sim::Scene& scene) {
  constexpr double k_share = 0.25;
  add_grid(scene);
  for (sim::Surface& surface : scene.surfaces) {
    surface.specular = k_share;
    surface.metal = true;
    surface.index = sim::Color(0.02);
    surface.extinction = sim::Color(5);
  }
}

/// In rows, each turned another way.
void add_tori(sim::Scene& scene) {
  constexpr int k_number = 74;
  constexpr int k_columns = 12;
  constexpr double k_step = 1.1;
  for (int i = 0; i < k_number; ++i) {
    const double x = k_step * (i % k_columns - (k_columns - 1) / 2.0);
    const int row = i / k_columns;
    const double y = 1.7 * (row - 3);
    const glm::dmat4 turned =
        glm::rotate(glm::dmat4(1.0), 0.7 * i, glm::normalize(glm::dvec3(1, 0.4 * (i % 5), 0.5)));
    sim::Placement placement(turned);
    placement[3] = {x, y, 0.6};
    add(scene, sim::TorusShape{0.38, 0.15}, "torus", placement);
  }
}

void add_nothing(sim::Scene& /*scene*/) {}

}  // namespace

const std::vector<PeerScene>& peer_scenes() {
  static const std::vector<PeerScene> scenes{
      {"quadrics", "quadrics", add_nothing, 0.4,
       "ten quadrics with CSG, mirror, lens, glass, two lights, depth 5"},
      {"grid", "grid", add_grid, 0.45, "100 spheres and 100 cylinders on a plane, two lights"},
      {"reflecting_grid", "grid", add_reflecting_grid, 0.5, "the same, all reflecting 25 %"},
      {"vase", "vase", add_nothing, 0.17, "a vase of 8 sections on a floor, with shadow"},
      {"tori", "tori", add_tori, 0.8, "74 tori on two planes, with shadows"}};
  return scenes;
}

}  // namespace maquette::benchmark
