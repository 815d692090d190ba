#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "models/unit/pixel_leg.hpp"

namespace maquette::sim {

/// Lists of words, those that are alike once.
class DistinctLists {
 public:
  using Words = std::vector<std::uint32_t>;

  /// The place of a list, which is put behind the others when it is a new one.
  std::uint32_t place_of(const Words& list);

  std::vector<Words> lists;

 private:
  std::unordered_map<std::string, std::uint32_t> places_;
};

/// The legs of many pixels. Pixels beside one another often have the same, and most others differ
/// by a few: legs that are alike are kept once, and so are runs of them up to the photometry and
/// the chains of runs that pixels are.
class LegTable {
 public:
  /// Puts the legs of the next pixel.
  void put(const std::vector<models::PixelLeg>& legs);
  /// Puts the pixels of another table behind those of this one.
  void append(const LegTable& other);

  [[nodiscard]] std::size_t pixels() const { return chain_of_pixel_.size(); }
  /// The legs of a pixel, in the order of put.
  [[nodiscard]] std::vector<models::PixelLeg> legs(std::size_t pixel) const;

  /// All of it in words, the same ones for the same pixels in the same order.
  [[nodiscard]] std::vector<std::uint32_t> words() const;
  /// Puts what such words hold into an empty table; says what is wrong with them, nothing when all
  /// is well.
  [[nodiscard]] std::string read(const std::vector<std::uint32_t>& words);

 private:
  using Words = DistinctLists::Words;

  std::uint32_t place_of(const models::PixelLeg& leg);

  std::vector<models::PixelLeg> legs_;
  std::unordered_map<std::string, std::uint32_t> leg_places_;
  DistinctLists runs_;    // of legs
  DistinctLists chains_;  // of runs
  Words chain_of_pixel_;
};

}  // namespace maquette::sim
