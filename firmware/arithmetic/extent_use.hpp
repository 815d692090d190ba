#pragma once

#include <cstdint>

/// Which extents rays are compared with, and what comes of it. Boards compare with all; where work
/// is counted some may be left out, to see what they are worth (paper, section II.3).
namespace maquette::firmware {

enum class ExtentKind : std::uint8_t { rectangle, box, sphere };
inline constexpr int k_extent_kind_count = 3;

/// Keys of stats.json.
inline constexpr const char* k_extent_names[k_extent_kind_count] = {"rectangles", "boxes",
                                                                    "spheres"};

template <class Real>
struct ExtentUse {
  static constexpr bool is_chosen = false;  ///< whether it may be less than all
  static constexpr bool tests_rectangles = true;
  static constexpr bool tests_boxes = true;
  static constexpr bool tests_spheres = true;

  /// Takes down what a comparison has told of a node. Only `Counted` does.
  [[gnu::always_inline]] static constexpr void note(ExtentKind /*kind*/, std::uint32_t /*node*/,
                                                    bool /*is_met*/) {}
  /// The same of a box, by where the ray enters it.
  [[gnu::always_inline]] static constexpr void note_entry(std::uint32_t /*node*/,
                                                          const Real& /*entry*/) {}
};

/// What comparisons with one kind of extent have told.
struct ExtentCounts {
  std::uint64_t tests;
  std::uint64_t hits;
  std::uint64_t spared_leaves;  ///< below the nodes that were not met
};

}  // namespace maquette::firmware
