#include <algorithm>
#include <random>

#include "models/bus/arbitration_policies.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;

std::vector<Contender> random_contenders(std::mt19937& generator) {
  std::vector<Contender> contenders;
  for (int master = 0; master < 12; ++master) {
    if (traffic::below(generator, 2) == 1 || (master == 11 && contenders.empty())) {
      contenders.push_back({master, {traffic::below(generator, 5), master * 7 % 12}, Instant{}});
    }
  }
  std::reverse(contenders.begin(), contenders.end());
  return contenders;
}

Contenders view(const std::vector<Contender>& contenders) {
  return {contenders.data(), contenders.data() + contenders.size()};
}

TEST_CASE("priority: nobody is above the winner, nor before it on its level") {
  std::mt19937 generator(11);
  for (int one = 0; one < 2000; ++one) {
    const auto contenders = random_contenders(generator);
    const int winner = k_priority.choose(view(contenders), one % 12);
    const auto chosen =
        std::find_if(contenders.begin(), contenders.end(),
                     [winner](const Contender& contender) { return contender.master == winner; });
    REQUIRE(chosen != contenders.end());
    for (const Contender& other : contenders) {
      REQUIRE(other.place.level <= chosen->place.level);
      if (other.place.level == chosen->place.level) {
        REQUIRE(other.place.position >= chosen->place.position);
      }
    }
  }
}

TEST_CASE("round robin: no contender stands between the previous master and the winner") {
  std::mt19937 generator(12);
  for (int one = 0; one < 2000; ++one) {
    const auto contenders = random_contenders(generator);
    const int previous = traffic::below(generator, 13) - 1;
    const int winner = k_round_robin.choose(view(contenders), previous);
    const auto turns = [previous](int master) { return (master - previous - 1 + 24) % 12; };
    REQUIRE(std::any_of(contenders.begin(), contenders.end(),
                        [winner](const Contender& one_of) { return one_of.master == winner; }));
    for (const Contender& other : contenders) {
      REQUIRE(turns(other.master) >= turns(winner));
    }
  }
}

}  // namespace
