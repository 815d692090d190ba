#include "sim/database/surface_packing.hpp"

#include "firmware/facets/facet_table.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

TEST_CASE("A surface gets the shape of its distribution by the half angle in degrees") {
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    Surface surface;
    surface.facets = static_cast<firmware::FacetKind>(kind);
    surface.half_angle_deg = 45;
    const firmware::Surface<double> packed = packed_surface(surface);
    const firmware::FacetDistribution& facets = firmware::distribution_of(surface.facets);
    const firmware::FacetShape shape = facets.shape(firmware::elementary::k_pi / 4);
    CAPTURE(facets.name);
    CHECK(packed.facets == surface.facets);
    CHECK(packed.facet_parameter == Approx(shape.parameter));
    CHECK(packed.facet_scale == Approx(shape.scale));
  }
}

TEST_CASE("Only transparent matter absorbs") {
  Surface surface;
  surface.absorption = {1, 0, 0};
  CHECK_FALSE(packed_surface(surface).absorbing);
  surface.transparent = true;
  CHECK(packed_surface(surface).absorbing);
  surface.absorption = {0, 0, 0};
  CHECK_FALSE(packed_surface(surface).absorbing);
}

}  // namespace
}  // namespace maquette::sim
