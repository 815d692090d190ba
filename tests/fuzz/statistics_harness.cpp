#include <random>

#include "sim/report/scalar_statistics.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/sim/report/random_statistics.hpp"

namespace maquette::fuzz {

void try_statistics(const std::string& input) {
  try {
    const sim::Statistics statistics = sim::parse_statistics(input, "stats.json");
    const std::string written = sim::statistics_json(statistics);
    try {
      require(sim::statistics_json(sim::parse_statistics(written, "written.json")) == written,
              "statistics are others when they are read again");
    } catch (const sim::DescriptionError& error) {
      throw BrokenLaw(std::string{"statistics that were written are refused: "} + error.what());
    }
    static_cast<void>(sim::scalar_statistics(statistics));
  } catch (const sim::DescriptionError&) {
    return;
  }
}

std::vector<std::string> statistics_seeds() {
  constexpr int k_seeds = 4;
  std::mt19937_64 random{1984};
  std::vector<std::string> seeds{sim::statistics_json({})};
  for (int i = 0; i < k_seeds; ++i) {
    seeds.push_back(sim::statistics_json(tests::random_statistics(random)));
  }
  return seeds;
}

}  // namespace maquette::fuzz
