// The build compiles this file, as the rooms of results, where SystemC cannot be seen.
#include "models/machine/machine_statistics.hpp"

#include <type_traits>

#include "tests/catch.hpp"

namespace {

using namespace maquette::models;

template <class Statistics>
constexpr bool is_plain_data =
    std::conjunction_v<std::is_aggregate<Statistics>, std::is_copy_assignable<Statistics>,
                       std::is_nothrow_move_constructible<Statistics>>;

TEST_CASE("statistics of a machine are plain data, made and kept without one") {
  STATIC_REQUIRE(is_plain_data<MachineStatistics>);
  STATIC_REQUIRE(is_plain_data<BoardStatistics>);
  STATIC_REQUIRE(is_plain_data<HostStatistics>);
  STATIC_REQUIRE(is_plain_data<BusStatistics>);
  STATIC_REQUIRE(is_plain_data<BusMasterStatistics>);
  MachineStatistics made;
  made.boards.resize(3);
  made.boards[2].work.primary = 7;
  const MachineStatistics kept = made;
  made.boards.clear();
  CHECK(kept.boards.at(2).work.primary == 7);
  CHECK_FALSE(kept.has_finished);
}

}  // namespace
