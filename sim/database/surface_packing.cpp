#include "sim/database/surface_packing.hpp"

#include "firmware/facets/facet_table.hpp"
#include "sim/database/texture_packing.hpp"

namespace maquette::sim {

firmware::Surface<double> packed_surface(const Surface& surface) {
  const double half_angle = surface.half_angle_deg * firmware::elementary::k_pi / 180;
  const firmware::FacetShape shape = firmware::distribution_of(surface.facets).shape(half_angle);
  firmware::Surface<double> packed{};
  packed.diffuse = packed_diffuse(surface);
  packed.specular = surface.specular;
  packed.metal = surface.metal;
  packed.transparent = surface.transparent;
  packed.absorbing = surface.transparent && surface.absorption != Color(0, 0, 0);
  packed.facets = surface.facets;
  packed.index = surface.index;
  packed.extinction = surface.extinction;
  packed.facet_parameter = shape.parameter;
  packed.facet_scale = shape.scale;
  packed.absorption = surface.absorption;
  return packed;
}

}  // namespace maquette::sim
