#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "models/unit/pixel_leg.hpp"
#include "models/unit/unit_parameters.hpp"

namespace maquette::sim {

/// Which legs are told apart from those of the board: by stage, a bit for each kind of ray.
using LegsApart = std::array<std::uint64_t, models::k_stage_count>;

/// All are.
constexpr LegsApart all_legs_apart() {
  LegsApart apart{};
  for (std::uint64_t& rays : apart) {
    rays = ~std::uint64_t{0};
  }
  return apart;
}

/// Those that units of a machine do; all for one without units.
[[nodiscard]] LegsApart legs_apart_for(const models::UnitsParameters& units);

/// Tells the legs of the pixels that this thread synthesises while it exists: what is counted from
/// one marker of the firmware to the next. One a thread. Between `start` and `take` the meter is
/// not to be asked, nor reset.
class LegTeller {
 public:
  /// What is not apart is a part of the board's leg around it.
  explicit LegTeller(const LegsApart& apart = all_legs_apart());
  LegTeller(const LegTeller&) = delete;
  LegTeller& operator=(const LegTeller&) = delete;
  LegTeller(LegTeller&&) = delete;
  LegTeller& operator=(LegTeller&&) = delete;
  ~LegTeller();

  /// A pixel begins, from what the meter has counted so far.
  void start();
  /// The legs of the pixel, which is over. A part that counted nothing makes none, and what the one
  /// around it does before and after is one leg then. Valid until the next pixel. Throws
  /// std::overflow_error when one is handed more words than a PixelLeg can tell.
  const std::vector<models::PixelLeg>& take();

 private:
  /// A bit for each function by kind of ray, as the meter has them.
  using Cells = std::array<std::uint64_t, firmware::k_ray_kind_count>;

  /// A part of the process that has begun and not ended.
  struct Part {
    firmware::Stage stage = firmware::Stage::board;
    int primitive = 0;
    firmware::RayKind ray = firmware::RayKind::primary;
    firmware::LegMessages messages{};
    int handed_in = 0;         ///< to whoever does what comes next of it
    std::size_t last_leg = 0;  ///< behind the place of its last one
    std::uint64_t rays = 0;    ///< a bit for each kind of which it has cells
    bool is_boards = true;     ///< not apart
    int joined = 0;            ///< parts in it that have begun, are not apart and have not ended
  };

  void begin(firmware::Stage stage, int primitive, const firmware::LegMessages& messages);
  void end();
  void cut(int handed_out);
  std::uint16_t words_of(int words);
  bool take_work(Part& part, firmware::LongWork& work);
  firmware::CountedMeter::Cell* told_of(std::uint32_t kind);
  void give_back();

  LegsApart apart_;
  firmware::LegListener listener_;
  std::array<std::vector<firmware::CountedMeter::Cell>, firmware::k_ray_kind_count>
      told_;                      // counts of all cells, as far as they are in legs, by kind of ray
  Cells known_{};                 // of which they are not 0
  std::uint64_t known_rays_ = 0;  // kinds of which that may be
  Cells entered_{};               // what has been taken away of the meter's
  int most_words_ = 0;            // that a leg of the pixel is handed, or hands back
  std::vector<Part> parts_;
  std::vector<Cells> cells_;  // in which each of the parts may count, for its kinds of rays
  std::vector<models::PixelLeg> legs_;
};

}  // namespace maquette::sim
