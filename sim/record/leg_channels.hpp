#pragma once

#include <string>

#include "sim/picture_module/exr_codec.hpp"
#include "sim/record/leg_table.hpp"

/// The legs of a record's pixels in its file: the words of their table fill channels of whole
/// numbers, row by row, which is how the file compresses and checks them.
namespace maquette::sim {

/// The attribute of a record's header with the number of words and their SHA-1; of a record
/// without legs there is none.
inline constexpr const char* k_leg_words = "maquetteLegWords";

/// Whether the header says that there are legs.
[[nodiscard]] bool has_legs(const ExrImage& image);

/// Adds the channels and the attribute. The table has pixels.
void append_legs(const LegTable& legs, ExrImage& image);

/// The attribute for the channels as they are; of a record without legs nothing.
[[nodiscard]] std::string leg_digest(const ExrImage& image);

/// Adds the channels that the attribute says, empty: what is to be decoded besides. Says what is
/// wrong with it, nothing when all is well.
[[nodiscard]] std::string expect_legs(ExrImage& image);

/// Puts what the channels of a record with legs hold into an empty table; says what is wrong,
/// nothing when all is well.
[[nodiscard]] std::string read_legs(const ExrImage& image, LegTable& legs);

}  // namespace maquette::sim
