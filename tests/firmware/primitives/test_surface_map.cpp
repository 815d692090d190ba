#include "firmware/primitives/surface_map_table.hpp"

#include <cmath>
#include <vector>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

using trial::Random;

constexpr double k_pi = elementary::k_pi;

TEST_CASE("A turn goes from the x axis by way of the y axis and once around") {
  Random random(1301);
  for (int i = 0; i < 5000; ++i) {
    const double turn = random.uniform(0, 0.999999);
    const double radius = random.magnitude(1e-3, 1e3);
    CHECK(turn_of(radius * std::cos(2 * k_pi * turn), radius * std::sin(2 * k_pi * turn)) ==
          Approx(turn).margin(1e-7));
  }
  CHECK(turn_of(0.0, 0.0) == 0);
  CHECK(turn_of(1.0, -0.0) == 0);
}

TEMPLATE_TEST_CASE("Every place lies in the picture", "", float, double) {
  using Real = TestType;
  Random random(1302);
  const std::vector<Real> parameters{Real(0.3)};
  for (const PrimitiveKind kind : {kind_of<sphere::Kind>, kind_of<cylinder::Kind>,
                                   kind_of<cone::Kind>, kind_of<box::Kind>, kind_of<torus::Kind>}) {
    for (int i = 0; i < 5000; ++i) {
      const auto face = static_cast<std::uint8_t>(random.below(kind == kind_of<box::Kind> ? 6 : 3));
      const Vector<double> p = random.in_cube(2.2);  // a little off the surface, too
      const SurfacePlace<Real> place =
          surface_map_of<Real>(kind)({Real(p.x), Real(p.y), Real(p.z)}, face, parameters.data());
      for (const int texels : {1, 3, 24, 1000, 4096}) {
        REQUIRE(place.u * Real(texels) < Real(texels));
        REQUIRE(place.v * Real(texels) < Real(texels));
      }
      REQUIRE(place.u >= Real(0));
      REQUIRE(place.v >= Real(0));
    }
  }
}

TEST_CASE("Equal parts of a sphere's and a cylinder's picture are equal angles and heights") {
  Random random(1303);
  for (int i = 0; i < 1000; ++i) {
    const double u = random.uniform(0, 0.9999);
    const double v = random.uniform(0, 0.9999);
    const double latitude = k_pi * (v - 0.5);
    const double longitude = 2 * k_pi * u;
    const SurfacePlace<double> on_sphere = sphere::surface_place<double>(
        {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
         std::sin(latitude)},
        0, nullptr);
    CHECK(on_sphere.u == Approx(u).margin(1e-6));
    CHECK(on_sphere.v == Approx(v).margin(1e-6));
    const SurfacePlace<double> on_side = cylinder::surface_place<double>(
        {std::cos(longitude), std::sin(longitude), 2 * v - 1}, cylinder::k_side, nullptr);
    CHECK(on_side.u == Approx(u).margin(1e-6));
    CHECK(on_side.v == Approx(v).margin(1e-9));
    const double top = 0.25;
    const double z = top + (1 - top) * v;
    const SurfacePlace<double> on_cone = cone::surface_place<double>(
        {z * std::cos(longitude), z * std::sin(longitude), z}, cone::k_side, &top);
    CHECK(on_cone.u == Approx(u).margin(1e-6));
    CHECK(on_cone.v == Approx(v).margin(1e-9));
    const double minor = 0.3;
    const double radius = 1 - minor + minor * std::cos(2 * k_pi * v);
    const SurfacePlace<double> on_torus =
        torus::surface_place<double>({radius * std::cos(longitude), radius * std::sin(longitude),
                                      minor * std::sin(2 * k_pi * v)},
                                     0, &minor);
    CHECK(on_torus.u == Approx(u).margin(1e-6));
    CHECK(on_torus.v == Approx(v).margin(1e-6));
  }
}

TEST_CASE("A picture is not mirrored on any face of a box, and stands upright on its sides") {
  for (std::uint8_t face = 0; face < 6; ++face) {
    const Vector<double> zero(0, 0, 0);
    Vector<double> normal = zero;
    normal[face / 2] = face % 2 == 0 ? 1 : -1;
    // The directions along which u and v grow.
    Vector<double> along_u = zero;
    Vector<double> along_v = zero;
    for (int axis = 0; axis < 3; ++axis) {
      Vector<double> step = zero;
      step[axis] = 0.5;
      const SurfacePlace<double> place = box::surface_place<double>(step, face, nullptr);
      along_u[axis] = place.u - 0.5;
      along_v[axis] = place.v - 0.5;
    }
    CAPTURE(int{face});
    CHECK(glm::dot(glm::cross(along_u, along_v), normal) > 0);
    CHECK((face / 2 == 2 || along_v.z > 0));
  }
}

TEST_CASE("A revolution's picture follows its generatrix, a patch's its parameters") {
  // A cylinder of radius 1 from z = 0 to z = 2 in two straight sections.
  const std::vector<double> straight{2, 1,       1,  // header
                                     0, 2,       1, 1,       0, 1,       1, 1,
                                     1, 2,       1, 1,                          // extents
                                     1, 0,       1, 1.0 / 3, 1, 2.0 / 3, 1, 1,  // first section
                                     1, 4.0 / 3, 1, 5.0 / 3, 1, 2};             // second section
  Random random(1304);
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 0.999);
    const double v = random.uniform(0.001, 0.999);
    const double z = 2 * v;
    const auto face = static_cast<std::uint8_t>(z < 1 ? 0 : 1);
    const SurfacePlace<double> place = revolution::surface_place<double>(
        {std::cos(2 * k_pi * u), std::sin(2 * k_pi * u), z}, face, straight.data());
    CHECK(place.u == Approx(u).margin(1e-6));
    CHECK(place.v == Approx(v).margin(1e-6));
  }
  const SurfacePlace<double> on_disc =
      revolution::surface_place<double>({0.5, -0.5, 2}, revolution::k_last_disc, straight.data());
  CHECK(on_disc.u == Approx(0.75));
  CHECK(on_disc.v == Approx(0.25));

  std::vector<double> flat{1, 0, 1, 0.5, 0.5, 0, 0.5, 0.5, 0};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      flat.insert(flat.end(), {row / 3.0, column / 3.0, 0});
    }
  }
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(0.001, 0.999);
    const double y = random.uniform(0.001, 0.999);
    const SurfacePlace<double> place = patches::surface_place<double>({x, y, 0}, 0, flat.data());
    // Which way round the two run is the patch's own affair.
    CHECK(smaller(place.u, place.v) == Approx(smaller(x, y)).margin(1e-4));
    CHECK(larger(place.u, place.v) == Approx(larger(x, y)).margin(1e-4));
  }
}

TEST_CASE("Primitives without parameters of their own have no map") {
  CHECK(surface_map_of<double>(kind_of<half_space::Kind>) == nullptr);
  CHECK(surface_map_of<double>(kind_of<terrain::Kind>) == nullptr);
  CHECK(surface_map_of<double>(kind_of<sphere::Kind>) != nullptr);
}

}  // namespace
}  // namespace maquette::firmware
