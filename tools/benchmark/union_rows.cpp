#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

#include "sim/database/frame_synthesis.hpp"
#include "sim/primitives/box.hpp"
#include "sim/primitives/sphere.hpp"
#include "tools/benchmark/rows.hpp"

/// Unions of many bodies: what a ray costs, and what their tree does.
namespace maquette::benchmark {

namespace {

constexpr int k_repetitions = 3;
constexpr int k_fewest = 100;
constexpr int k_most = 100'000;

/// How the size of the bodies goes with their number.
enum class Filling { same_volume, same_area };

double radius_of(int count, Filling filling) {
  constexpr double k_radius = 0.113;  // of the fewest
  const double ratio = static_cast<double>(k_fewest) / count;
  return k_radius * (filling == Filling::same_volume ? std::cbrt(ratio) : std::sqrt(ratio));
}

/// Spheres and boxes by turns, at random in a cube.
std::vector<sim::Object> bodies(int count, Filling filling) {
  std::mt19937 engine(1984);
  const auto uniform = [&engine] { return static_cast<double>(engine()) / 2147483648.0 - 1; };
  const double radius = radius_of(count, filling);
  std::vector<sim::Object> result;
  for (int i = 0; i < count; ++i) {
    sim::Object body;
    if (i % 2 == 0) {
      body.primitive = sim::primitive_of(sim::SphereShape{sim::Vector3(radius)});
    } else {
      body.primitive = sim::primitive_of(sim::BoxShape{sim::Vector3(1.6 * radius)});
    }
    const double x = uniform();
    const double y = uniform();
    body.placement[3] = {x, y, uniform()};
    result.push_back(std::move(body));
  }
  return result;
}

sim::Object union_of(std::vector<sim::Object> children) {
  sim::Object object;
  object.combination = firmware::BooleanOperator::union_of;
  object.children = std::move(children);
  return object;
}

/// Unions of two, one within the other: their order is kept.
sim::Object chained(const std::vector<sim::Object>& children) {
  sim::Object object = children.front();
  for (std::size_t i = 1; i < children.size(); ++i) {
    object = union_of({std::move(object), children[i]});
  }
  return object;
}

struct Measured {
  double ray_ns;
  double packing_s;
  double preprocessing_s;
};

Measured measured(sim::Object object) {
  sim::Scene scene;
  scene.view.eye = {0.3, -4, 1.1};
  scene.view.target = {0, 0, 0};
  scene.view.field_of_view_deg = 40;
  scene.lights.push_back({"sun", {3, -5, 8}, {1, 1, 1}, {}, {}, {}});
  scene.surfaces.emplace_back().name = "matt";
  scene.object = std::move(object);
  scene.object.surface = "matt";
  const std::clock_t start = std::clock();
  sim::PackedScene<float> packed = sim::packed_scene<float>(scene, {384, 288});
  const std::clock_t is_packed = std::clock();
  const sim::PreparedScene<float> prepared(std::move(packed));
  const std::clock_t is_prepared = std::clock();
  double least = 1e9;
  for (int i = 0; i < k_repetitions; ++i) {
    const sim::SynthesizedFrame frame = sim::synthesized_frame(prepared);
    least = std::min(least, frame.time_s / static_cast<double>(frame.rays));
  }
  const auto seconds = [](std::clock_t from, std::clock_t to) {
    return static_cast<double>(to - from) / CLOCKS_PER_SEC;
  };
  return {least * 1e9, seconds(start, is_packed), seconds(is_packed, is_prepared)};
}

void add_rows(Filling filling, const char* name, const char* meaning, std::optional<double> bound,
              std::vector<Row>& rows) {
  double fewest_ns = 0;
  for (int count = k_fewest; count <= k_most; count *= 10) {
    const Measured result = measured(union_of(bodies(count, filling)));
    rows.push_back({fmt::format("{}_{}", name, count), result.ray_ns, "ns", std::nullopt,
                    fmt::format("a ray in a picture of so many bodies, {}", meaning)});
    if (count == k_fewest) {
      fewest_ns = result.ray_ns;
    }
    if (count == k_most) {
      rows.push_back({fmt::format("{}_growth", name), result.ray_ns / fewest_ns, "1", bound,
                      "the most against the fewest"});
      rows.push_back({fmt::format("{}_packing", name), result.packing_s, "s", std::nullopt,
                      "frames and tree of the most"});
      rows.push_back({fmt::format("{}_preprocessing", name), result.preprocessing_s, "s",
                      std::nullopt, "extents of the most"});
    }
  }
}

}  // namespace

std::vector<Row> measure_unions(const Paths& /*paths*/) {
  constexpr double k_growth_bound = 8;
  constexpr int k_chained = 1000;
  std::vector<Row> rows;
  add_rows(Filling::same_volume, "union", "of the same volume together", k_growth_bound, rows);
  add_rows(Filling::same_area, "sparse_union", "of the same area together", std::nullopt, rows);
  const Measured result = measured(chained(bodies(k_chained, Filling::same_volume)));
  rows.push_back({fmt::format("chain_{}", k_chained), result.ray_ns, "ns", std::nullopt,
                  "a ray against so many bodies united one by one, their order kept"});
  return rows;
}

}  // namespace maquette::benchmark
