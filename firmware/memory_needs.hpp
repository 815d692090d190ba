#pragma once

#include <cstdint>

#include "firmware/database.hpp"
#include "firmware/primitives/primitive_table.hpp"

/// How many bytes of a board's RAM a scene takes, by fields with the 68000's alignment of two
/// bytes: node numbers, counts and flags are words, reals and pointers long words.
namespace maquette::firmware {

inline constexpr std::int64_t k_real_bytes = 4;
inline constexpr std::int64_t k_word_bytes = 2;
inline constexpr std::int64_t k_affine_bytes = 12 * k_real_bytes;

/// Parent, kind, surface, first parameter; direct and inverse transforms.
inline constexpr std::int64_t k_leaf_bytes = 4 * k_word_bytes + 2 * k_affine_bytes;
/// Parent, two children, operator.
inline constexpr std::int64_t k_composite_bytes = 4 * k_word_bytes;
inline constexpr std::int64_t k_light_bytes = 6 * k_real_bytes;
/// Both frames, left, top, step, columns, rows.
inline constexpr std::int64_t k_observer_bytes =
    2 * k_affine_bytes + 3 * k_real_bytes + 2 * k_word_bytes;
/// Bits that tell a board the needs of a scene besides its primitives.
inline constexpr int k_further_need_bits = 18;
/// Words of the needs as bits, one for each primitive and the further ones.
inline constexpr std::int64_t k_need_words =
    (k_primitive_kind_count + k_further_need_bits + 15) / 16;
/// Three counts and the root as long words, three words, the needs; ambient, background, least
/// weight.
inline constexpr std::int64_t k_header_bytes =
    (11 + k_need_words) * k_word_bytes + 7 * k_real_bytes;

/// Both frames and the scale.
inline constexpr std::int64_t k_prepared_leaf_bytes = 2 * k_affine_bytes + k_real_bytes;
/// Box, sphere with its squared radius, rectangle, flags.
inline constexpr std::int64_t k_extent_bytes = 11 * k_real_bytes + 5 * k_word_bytes;
inline constexpr std::int64_t k_prepared_surface_bytes = 6 * k_real_bytes;
inline constexpr std::int64_t k_prepared_light_bytes = 3 * k_real_bytes;

/// Distance, leaf, face, medium.
inline constexpr std::int64_t k_crossing_bytes = k_real_bytes + 3 * k_word_bytes;
/// Origin, direction, weight, depth, leaf left behind.
inline constexpr std::int64_t k_pending_ray_bytes = 9 * k_real_bytes + 2 * k_word_bytes;

/// A surface: flags and share always, the rest only where the scene needs it.
constexpr std::int64_t surface_bytes(const Needs& needs) {
  std::int64_t bytes = k_word_bytes + k_real_bytes;
  bytes += needs.diffuse ? 3 * k_real_bytes : 0;
  bytes += needs.specular ? 2 * k_real_bytes : 0;
  if (needs.metals) {
    bytes += 6 * k_real_bytes;
  } else if (needs.dielectrics) {
    bytes += k_real_bytes;
  }
  bytes += needs.absorption ? 3 * k_real_bytes : 0;
  return bytes;
}

/// What the host loads: the scene.
template <class Real>
std::int64_t database_bytes(const Database<Real>& database) {
  return k_header_bytes + k_observer_bytes + database.leaf_count * k_leaf_bytes +
         database.composite_count * k_composite_bytes + database.parameter_count * k_real_bytes +
         database.surface_count * surface_bytes(database.needs) +
         database.light_count * k_light_bytes;
}

/// What preprocessing adds to it.
template <class Real>
std::int64_t prepared_bytes(const Database<Real>& database) {
  return database.leaf_count * k_prepared_leaf_bytes + database.node_count() * k_extent_bytes +
         (database.needs.diffuse ? database.surface_count * k_prepared_surface_bytes : 0) +
         database.light_count * k_prepared_light_bytes +
         (database.needs.depth ? 2 * k_real_bytes : 0);
}

/// The most crossings that a ray can have with a node, and the space its evaluation takes.
struct CrossingNeeds {
  std::int64_t result;
  std::int64_t space;
};

template <class Real>
CrossingNeeds crossing_needs_of_leaf(const Database<Real>& database, const Leaf<Real>& leaf) {
  const std::int64_t hits =
      primitive_of<Real>(leaf.kind).hit_limit(database.parameters + leaf.first_parameter);
  return {hits, hits};
}

/// Operands lie one behind the other, their combination behind both.
constexpr CrossingNeeds combined_crossing_needs(const CrossingNeeds& a, const CrossingNeeds& b) {
  const std::int64_t result = a.result + b.result;
  const std::int64_t second = a.result + b.space;
  const std::int64_t operands = a.space > second ? a.space : second;
  return {result, operands > 2 * result ? operands : 2 * result};
}

/// Rays that can wait at once: each ray followed leaves at most two, of which one is followed.
constexpr std::int64_t pending_rays_needed(std::int32_t ray_depth, bool transparency) {
  return transparency ? ray_depth + 1 : 1;
}

}  // namespace maquette::firmware
