#include <filesystem>

#include "firmware/primitives/patches.hpp"
#include "sim/primitives/patches.hpp"
#include "sim/scene/description_loader.hpp"
#include "tools/benchmark/ray_timing.hpp"
#include "tools/benchmark/rows.hpp"

/// Rays against the 32 patches of the teapot.
namespace maquette::benchmark {

namespace {

namespace patches = firmware::patches;

/// The first set of patches in an object's tree; a null pointer when there is none.
const sim::PatchesShape* find_patches(const sim::Object& object) {
  if (object.primitive) {
    return sim::shape_of<sim::PatchesShape>(*object.primitive);
  }
  for (const sim::Object& child : object.children) {
    if (const sim::PatchesShape* found = find_patches(child)) {
      return found;
    }
  }
  return nullptr;
}

sim::PatchesShape teapot(const Paths& paths) {
  const std::filesystem::path scene =
      std::filesystem::path{paths.scene}.replace_filename("teapot.yaml");
  return *find_patches(sim::load_description({scene.string(), {}, {}, paths.models}).scene.object);
}

/// Millions of rays in a second.
template <class Real>
double rate(sim::PatchesShape shape, sim::PatchMethod method) {
  shape.method = method;
  const std::vector<double> exact = sim::frame_of(shape).parameters;
  const std::vector<Real> parameters(exact.begin(), exact.end());
  const std::vector<firmware::Ray<Real>> rays = ordinary_rays<Real>();
  firmware::Hit<Real> hits[patches::k_hit_limit];
  const double ns = least_ns(k_rays, [&] {
    int count = 0;
    for (const firmware::Ray<Real>& ray : rays) {
      count += patches::intersect(ray, parameters.data(), hits);
    }
    return count;
  });
  return 1000 / ns;
}

}  // namespace

std::vector<Row> measure_patches(const Paths& paths) {
  const sim::PatchesShape shape = teapot(paths);
  return {{"teapot_subdivision", rate<float>(shape, sim::PatchMethod::subdivision), "Mrays/s",
           std::nullopt, "the 32 patches of the teapot, by recursive subdivision, in float"},
          {"teapot_roots", rate<float>(shape, sim::PatchMethod::roots), "Mrays/s", std::nullopt,
           "the same by the roots of the equations"},
          {"teapot_double", rate<double>(shape, sim::PatchMethod::subdivision), "Mrays/s",
           std::nullopt, "by recursive subdivision, in double"}};
}

}  // namespace maquette::benchmark
