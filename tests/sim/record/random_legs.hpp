#pragma once

#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

#include "firmware/arithmetic/counted_meter.hpp"
#include "models/board/pixel_source.hpp"
#include "models/unit/pixel_leg.hpp"

/// Legs for the tests of what keeps them.
namespace maquette::sim {

/// A leg of few that there are, so that pixels have some in common.
inline models::PixelLeg random_leg(std::mt19937& random) {
  models::PixelLeg leg{};
  leg.stage = static_cast<models::Stage>(random() % models::k_stage_count);
  leg.ray = static_cast<firmware::RayKind>(random() % firmware::k_ray_kind_count);
  leg.primitive = static_cast<std::uint8_t>(random() % 4);
  leg.numbers_in = static_cast<std::uint16_t>(random() % 3);
  leg.numbers_out = static_cast<std::uint16_t>(random() % 2 == 0 ? 7 : 0xFFFF);
  for (int i = 0; i < 3; ++i) {
    leg.work.counts[random() % firmware::k_operation_count] =
        1 + static_cast<std::uint32_t>(random() % 3);
  }
  return leg;
}

inline std::vector<models::PixelLeg> random_legs(std::mt19937& random) {
  std::vector<models::PixelLeg> legs;
  for (auto left = random() % 6; left > 0; --left) {
    legs.push_back(random_leg(random));
  }
  return legs;
}

inline bool are_equal(const models::PixelLeg& a, const models::PixelLeg& b) {
  return a.stage == b.stage && a.ray == b.ray && a.primitive == b.primitive &&
         a.numbers_in == b.numbers_in && a.numbers_out == b.numbers_out &&
         std::equal(std::begin(a.work.counts), std::end(a.work.counts), std::begin(b.work.counts));
}

inline bool are_equal(const std::vector<models::PixelLeg>& a,
                      const std::vector<models::PixelLeg>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& one, const auto& other) { return are_equal(one, other); });
}

inline firmware::Work sum_of(const std::vector<models::PixelLeg>& legs) {
  firmware::Work sum{};
  for (const models::PixelLeg& leg : legs) {
    for (int i = 0; i < firmware::k_operation_count; ++i) {
      sum.counts[i] += leg.work.counts[i];
    }
  }
  return sum;
}

}  // namespace maquette::sim
