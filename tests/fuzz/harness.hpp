#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// What coverage-guided fuzzing tries: a harness reads any bytes as the program would and holds the
/// laws of what was read. The fuzzer and the tests run the same functions.
namespace maquette::fuzz {

/// One kind of input.
struct Harness {
  std::string_view name;
  /// Reads the input; returns where it is refused as bad input is. Throws BrokenLaw, or whatever
  /// else escapes, where the program is wrong.
  void (*try_input)(const std::string& input);
  /// Inputs to begin with.
  std::vector<std::string> (*seeds)();
};

/// What holds for every input does not hold for this one.
class BrokenLaw : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& law) {
  if (!holds) {
    throw BrokenLaw(law);
  }
}

void try_scene(const std::string& input);
void try_machine(const std::string& input);
void try_study(const std::string& input);
void try_values(const std::string& input);
void try_record(const std::string& input);
void try_container(const std::string& input);
void try_statistics(const std::string& input);

std::vector<std::string> scene_seeds();
std::vector<std::string> machine_seeds();
std::vector<std::string> study_seeds();
std::vector<std::string> values_seeds();
std::vector<std::string> record_seeds();
std::vector<std::string> container_seeds();
std::vector<std::string> statistics_seeds();

inline constexpr std::array<Harness, 7> k_harnesses{
    {{"scene", try_scene, scene_seeds},
     {"machine", try_machine, machine_seeds},
     {"study", try_study, study_seeds},
     {"values", try_values, values_seeds},
     {"record", try_record, record_seeds},
     {"container", try_container, container_seeds},
     {"statistics", try_statistics, statistics_seeds}}};

/// The harness of that name; throws std::invalid_argument where there is none.
inline const Harness& harness_named(std::string_view name) {
  for (const Harness& harness : k_harnesses) {
    if (harness.name == name) {
      return harness;
    }
  }
  throw std::invalid_argument("no harness " + std::string{name});
}

}  // namespace maquette::fuzz
