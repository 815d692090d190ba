#pragma once

#include <cstdint>
#include <vector>

#include "firmware/arithmetic/function.hpp"
#include "firmware/arithmetic/leg.hpp"
#include "firmware/arithmetic/work.hpp"

namespace maquette::models {

using firmware::Stage;

inline constexpr int k_stage_count = static_cast<int>(Stage::photometry) + 1;

/// The field's name of each stage, in the order of the enumeration.
inline constexpr const char* k_stage_names[k_stage_count] = {"board", "extents", "intersection",
                                                             "combination", "photometry"};

/// A part of a pixel's process that one function of it does in one go.
struct PixelLeg {
  Stage stage;
  firmware::RayKind ray;
  std::uint8_t primitive;     ///< its kind, of an intersection; else 0
  std::uint16_t numbers_in;   ///< handed to whoever does it, in words of 32 bits; of `board` 0
  std::uint16_t numbers_out;  ///< and handed back
  firmware::Work work;
};

/// The seam from which machines with function units know how a pixel is made; no other asks. It
/// goes with a PixelSource, whose pixel's work is the sum of its legs' works, class by class.
class LegSource {
 public:
  LegSource() = default;
  LegSource(const LegSource&) = delete;
  LegSource& operator=(const LegSource&) = delete;
  LegSource(LegSource&&) = delete;
  LegSource& operator=(LegSource&&) = delete;
  virtual ~LegSource() = default;

  /// The legs of the pixel that the PixelSource has given last, in their order, valid until it is
  /// asked for the next one.
  [[nodiscard]] virtual const std::vector<PixelLeg>& legs() = 0;
};

}  // namespace maquette::models
