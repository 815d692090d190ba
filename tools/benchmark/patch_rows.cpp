#include <filesystem>

#include "firmware/primitives/patches.hpp"
#include "sim/database/local_frame.hpp"
#include "sim/scene/description_loader.hpp"
#include "tools/benchmark/ray_timing.hpp"
#include "tools/benchmark/rows.hpp"

/// Rays against the 32 patches of the teapot.
namespace maquette::benchmark {

namespace {

namespace patches = firmware::patches;

/// The first set of patches in an object's tree; a null pointer when there is none.
const sim::Object* find_patches(const sim::Object& object) {
  if (object.kind == sim::ObjectKind::patches) {
    return &object;
  }
  for (const sim::Object& child : object.children) {
    if (const sim::Object* found = find_patches(child)) {
      return found;
    }
  }
  return nullptr;
}

sim::Object teapot(const Paths& paths) {
  const std::filesystem::path scene =
      std::filesystem::path{paths.scene}.replace_filename("teapot.yaml");
  return *find_patches(sim::load_description({scene.string(), {}, {}, paths.models}).scene.object);
}

/// Millions of rays in a second.
template <class Real>
double rate(sim::Object object, sim::PatchMethod method) {
  std::get<sim::PatchesShape>(object.shape).method = method;
  const std::vector<double> exact = sim::local_frame_of(object).parameters;
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
  const sim::Object object = teapot(paths);
  return {{"teapot_subdivision", rate<float>(object, sim::PatchMethod::subdivision), "Mrays/s",
           std::nullopt, "the 32 patches of the teapot, by recursive subdivision, in float"},
          {"teapot_roots", rate<float>(object, sim::PatchMethod::roots), "Mrays/s", std::nullopt,
           "the same by the roots of the equations"},
          {"teapot_double", rate<double>(object, sim::PatchMethod::subdivision), "Mrays/s",
           std::nullopt, "by recursive subdivision, in double"}};
}

}  // namespace maquette::benchmark
