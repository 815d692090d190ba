#pragma once

#include "firmware/facets/cosine_power.hpp"
#include "firmware/facets/gaussian.hpp"
#include "firmware/facets/trowbridge_reitz.hpp"
#include "firmware/kind_list.hpp"

namespace maquette::firmware {

/// The table of facet distributions (Blinn 1977): each is one row here, all else in the header of
/// its name.
using FacetKinds = KindList<cosine_power::Kind, gaussian::Kind, trowbridge_reitz::Kind>;

inline constexpr int k_facet_kind_count = FacetKinds::k_count;
static_assert(k_facet_kind_count <= k_facet_kind_limit);

struct FacetTable {
  FacetDistribution rows[k_facet_kind_count];
};

template <class... Kinds>
constexpr FacetTable facet_table(KindList<Kinds...> /*kinds*/) {
  return {{Kinds::k_distribution...}};
}

inline constexpr FacetTable k_facet_distributions = facet_table(FacetKinds{});

constexpr const FacetDistribution& distribution_of(FacetKind kind) {
  return k_facet_distributions.rows[static_cast<int>(kind)];
}

/// The kind of the facets of a distribution, e.g. facet_kind_of<gaussian::Kind>.
template <class Kind>
inline constexpr auto facet_kind_of = static_cast<FacetKind>(PlaceIn<Kind, FacetKinds>::k_value);

}  // namespace maquette::firmware
