#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/bus/duration.hpp"
#include "sim/report/statistics_field.hpp"

/// Statistics of function units, which are there only for machines that have some.
namespace maquette::sim {

/// A function unit; its five states sum to the frame time exactly.
struct FunctionUnitStatistics {
  std::string name;
  std::int64_t errands = 0;
  models::Duration serve{};
  models::Duration wait_grant{};
  models::Duration transfer{};
  models::Duration wait_place{};
  models::Duration idle{};
  double utilisation = 0;
  double queue_mean = 0;
  int queue_longest = 0;
  models::Duration queued_max{};

  static constexpr auto fields() {
    using Self = FunctionUnitStatistics;
    return std::make_tuple(
        field("name", "", "of the unit", &Self::name),
        field("errands", "errands", "served", &Self::errands),
        field("serve_s", "s", "the unit works, its clocks between two words included",
              &Self::serve),
        field("wait_grant_s", "s", "the bus is requested and not granted", &Self::wait_grant),
        field("transfer_s", "s", "the unit is bus master", &Self::transfer),
        field("wait_place_s", "s", "what it has served waits for a place with the next unit",
              &Self::wait_place),
        field("idle_s", "s", "the unit has no errand", &Self::idle),
        field("utilisation", "1", "what is not idle over frame time", &Self::utilisation),
        field("queue_mean", "errands", "that waited for service, over the frame time",
              &Self::queue_mean),
        field("queue_longest", "errands", "that waited for service together", &Self::queue_longest),
        field("queued_max_s", "s", "from an errand's arrival to its service, longest",
              &Self::queued_max));
  }
};

/// The units of one kind.
struct UnitKindStatistics {
  std::string kind;
  double utilisation = 0;
  models::Duration place_mean{};
  models::Duration place_max{};
  models::Duration queued_mean{};

  static constexpr auto fields() {
    using Self = UnitKindStatistics;
    return std::make_tuple(
        field("kind", "", "of the units", &Self::kind),
        field("utilisation", "1", "their mean", &Self::utilisation),
        field("place_mean_s", "s", "from asking for a place to having it, mean", &Self::place_mean),
        field("place_max_s", "s", "from asking for a place to having it, longest",
              &Self::place_max),
        field("queued_mean_s", "s", "from an errand's arrival to its service, mean",
              &Self::queued_mean));
  }
};

/// A board that had nothing to do until units had done something.
struct BoardWaits {
  std::string name;
  models::Duration wait{};
  std::vector<models::Duration> waited_for;

  static constexpr auto fields() {
    using Self = BoardWaits;
    return std::make_tuple(
        field("name", "", "of the board", &Self::name),
        field("wait_s", "s", "nothing to do but wait for units: the fifth of its states",
              &Self::wait),
        field("waited_for_s", "s",
              "of these, by kind in their order: until one of that kind had served, or had a place",
              &Self::waited_for));
  }
};

/// The second level of parallelism.
struct UnitsStatistics {
  std::string bottleneck;
  double bottleneck_utilisation = 0;
  double board_utilisation = 0;
  std::vector<UnitKindStatistics> kinds;
  std::vector<FunctionUnitStatistics> units;
  std::vector<BoardWaits> boards;

  static constexpr auto fields() {
    using Self = UnitsStatistics;
    return std::make_tuple(
        field("bottleneck", "", "the most utilised of boards, kinds of units and bus",
              &Self::bottleneck),
        field("bottleneck_utilisation", "1", "of it", &Self::bottleneck_utilisation),
        field("board_utilisation", "1", "of the boards: neither idle nor waiting for units, mean",
              &Self::board_utilisation),
        field("kinds", "", "of units", &Self::kinds),
        field("units", "", "states sum to the frame time", &Self::units),
        field("boards", "", "who waited for whom", &Self::boards));
  }
};

}  // namespace maquette::sim
