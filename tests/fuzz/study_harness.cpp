#include "sim/sweep/study_description.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "tests/fuzz/descriptions.hpp"
#include "tests/fuzz/harness.hpp"

namespace maquette::fuzz {

namespace {

constexpr std::size_t k_most_seed_bytes = 8192;
constexpr int k_few_values = 1000;

/// The values of a range lie between its ends, in their order.
void hold_range(const sim::ValueRange& range) {
  const double steps = (range.last - range.first) / range.step.value_or(1);
  if (range.count.value_or(0) > k_few_values || (!range.count && steps > k_few_values)) {
    return;
  }
  for (const bool is_whole : {false, true}) {
    const auto values = sim::values_of(range, is_whole);
    require(!values.empty(), "a range has no value");
    for (std::size_t i = 1; i < values.size(); ++i) {
      require(values[i - 1].value < values[i].value, "values of a range do not rise");
    }
  }
}

void hold_ranges(const sim::Axis& axis) {
  for (const auto& piece : axis.pieces) {
    if (const auto* range = std::get_if<sim::ValueRange>(&piece)) {
      try {
        hold_range(*range);
      } catch (const sim::DescriptionError&) {
        continue;
      }
    }
  }
}

}  // namespace

void try_study(const std::string& input) {
  try {
    const sim::Study study = sim::read_study(read_tree(input));
    const std::string written = sim::write_study(study);
    try {
      const sim::Study again = sim::read_study(sim::parse_yaml(written, "study.yaml"));
      require(sim::write_study(again) == written, "a study is another one when it is read again");
      require(sim::identity_of(again) == sim::identity_of(study),
              "a study has other points when it is read again");
    } catch (const sim::DescriptionError& error) {
      throw BrokenLaw(std::string{"a study that was written is refused: "} + error.what());
    }
    for (const sim::Axis& axis : study.axes) {
      hold_ranges(axis);
    }
  } catch (const sim::DescriptionError&) {
    return;
  }
}

std::vector<std::string> study_seeds() { return texts_below("scenes/studies", k_most_seed_bytes); }

}  // namespace maquette::fuzz
