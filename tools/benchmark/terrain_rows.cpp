#include <fmt/format.h>

#include "firmware/primitives/terrain.hpp"
#include "tools/benchmark/ray_timing.hpp"
#include "tools/benchmark/rows.hpp"

/// Rays against a terrain: from an observer to points of it, and from these points to the sun.
namespace maquette::benchmark {

namespace {

namespace terrain = firmware::terrain;

using Ray = firmware::Ray<float>;
using Vector = firmware::Vector<float>;

std::vector<float> terrain_parameters(std::int32_t levels) {
  const terrain::Shape<float> shape{levels, 1983, -0.5F, {0, 0, 0, 0}, 0.25F, 0.55F};
  std::vector<float> parameters(static_cast<std::size_t>(terrain::parameter_count(levels)));
  terrain::write_parameters(shape, parameters.data());
  return parameters;
}

std::vector<Ray> seen_rays(std::mt19937& engine) {
  const auto uniform = [&engine] { return static_cast<float>(engine() >> 8U) / 16777216.0F; };
  const Vector eye(0.5F, -0.8F, 0.6F);
  std::vector<Ray> rays;
  for (int i = 0; i < k_rays; ++i) {
    const float x = uniform();
    rays.push_back({eye, Vector(x, uniform(), 0) - eye});
  }
  return rays;
}

std::vector<Ray> shadow_rays(const std::vector<float>& parameters, const std::vector<Ray>& seen) {
  const Vector to_sun(0.6F, 0.3F, 0.5F);
  std::vector<Ray> rays;
  for (const Ray& ray : seen) {
    Vector place =
        terrain::settle(ray.origin + ray.direction, terrain::k_surface, parameters.data()).position;
    place.z += 1e-5F;
    rays.push_back({place, to_sun});
  }
  return rays;
}

Row row_of(const char* kind, std::int32_t levels, const std::vector<float>& parameters,
           const std::vector<Ray>& rays) {
  firmware::Hit<float> hits[terrain::k_hit_limit];
  const double ns = least_ns(k_rays, [&] {
    int count = 1;  // the coarsest terrain throws no shadow
    for (const Ray& ray : rays) {
      count += terrain::intersect(ray, parameters.data(), hits);
    }
    return count;
  });
  constexpr double k_thousand_ns = 1e3;
  return {fmt::format("terrain_{}_{}", levels, kind), k_thousand_ns / ns, "Mrays/s", std::nullopt,
          fmt::format("{} rays against a terrain of {} levels, {} triangles, float", kind, levels,
                      2LL << (2 * levels))};
}

}  // namespace

std::vector<Row> measure_terrain(const Paths& /*paths*/) {
  std::vector<Row> rows;
  for (const std::int32_t levels : {2, 4, 6, 8, 10}) {
    const std::vector<float> parameters = terrain_parameters(levels);
    std::mt19937 engine(1984);
    const std::vector<Ray> seen = seen_rays(engine);
    rows.push_back(row_of("primary", levels, parameters, seen));
    rows.push_back(row_of("shadow", levels, parameters, shadow_rays(parameters, seen)));
  }
  return rows;
}

}  // namespace maquette::benchmark
