#include "firmware/primitives/revolution.hpp"
#include "tools/benchmark/ray_timing.hpp"
#include "tools/benchmark/rows.hpp"

/// Rays against a vase of 18 control points, as many as the generatrix of the paper's photo 3 has.
namespace maquette::benchmark {

namespace {

namespace revolution = firmware::revolution;

constexpr int k_points = 18;

template <class Real>
std::vector<Real> vase_parameters() {
  constexpr double k_radii[k_points] = {0.05, 0.3, 0.5, 0.55, 0.6, 0.7,  0.85, 0.95, 1,
                                        0.95, 0.8, 0.6, 0.45, 0.4, 0.42, 0.5,  0.6,  0.65};
  const int sections = firmware::section_count(k_points, true);
  // Sections, open, tolerance of the roots, a B-spline; then its points.
  std::vector<Real> given = {static_cast<Real>(sections), 1, 1, 1};
  for (int i = 0; i < k_points; ++i) {
    const double height = -1.2 + 0.14 * i;
    given.insert(given.end(), {static_cast<Real>(k_radii[i]), static_cast<Real>(height)});
  }
  std::vector<Real> parameters(static_cast<std::size_t>(revolution::parameter_count(sections)));
  revolution::convert(given.data(), parameters.data());
  return parameters;
}

template <class Real>
double section_ns() {
  const std::vector<Real> parameters = vase_parameters<Real>();
  const revolution::Generatrix<Real> curve = revolution::generatrix(parameters.data());
  const std::vector<firmware::Ray<Real>> rays = ordinary_rays<Real>();
  firmware::Hit<Real> hits[revolution::k_section_degree];
  return least_ns(k_rays * curve.sections, [&] {
    int count = 0;
    for (const firmware::Ray<Real>& ray : rays) {
      const revolution::AxialRay<Real> axial = revolution::axial_ray(ray);
      for (int i = 0; i < curve.sections; ++i) {
        count += revolution::intersect_section(axial, curve.section(i),
                                               static_cast<std::uint8_t>(i), hits);
      }
    }
    return count;
  });
}

template <class Real>
double solid_ns() {
  const std::vector<Real> parameters = vase_parameters<Real>();
  const std::vector<firmware::Ray<Real>> rays = ordinary_rays<Real>();
  firmware::Hit<Real> hits[firmware::k_primitive_hit_limit];
  return least_ns(k_rays, [&] {
    int count = 0;
    for (const firmware::Ray<Real>& ray : rays) {
      count += revolution::intersect(ray, parameters.data(), hits);
    }
    return count;
  });
}

}  // namespace

std::vector<Row> measure_revolution(const Paths& /*paths*/) {
  constexpr double k_section_bound_ns = 100;
  return {{"section_float", section_ns<float>(), "ns", k_section_bound_ns,
           "a section of revolution against an ordinary ray, without extents"},
          {"section_double", section_ns<double>(), "ns", k_section_bound_ns, "the same in double"},
          {"vase_float", solid_ns<float>(), "ns", std::nullopt,
           "a vase of 15 sections with their tree of extents against an ordinary ray"},
          {"vase_double", solid_ns<double>(), "ns", std::nullopt, "the same in double"}};
}

}  // namespace maquette::benchmark
