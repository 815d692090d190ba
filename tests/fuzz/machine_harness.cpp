#include "sim/machine/machine_description.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/fuzz/descriptions.hpp"
#include "tests/fuzz/harness.hpp"

namespace maquette::fuzz {

namespace {

constexpr std::size_t k_most_seed_bytes = 8192;

sim::YamlNode shipped_table(const std::string& file) {
  return sim::load_yaml(std::string{MAQUETTE_PROJECT_DIRECTORY} + "/models/" + file);
}

/// Puts the shipped cost tables where the machine has none or names a file.
void give_tables(sim::YamlNode& machine) {
  static const sim::YamlNode k_arithmetic = shipped_table("arithmetic/motorola_ffp.yaml");
  static const sim::YamlNode k_program = shipped_table("program/mc68000.yaml");
  sim::YamlNode* board = machine.find("board");
  if (board == nullptr && machine.kind == sim::YamlKind::mapping) {
    append(machine, "board", sim::yaml_mapping());
    board = machine.find("board");
  }
  if (board == nullptr || board->kind != sim::YamlKind::mapping) {
    return;
  }
  const auto give = [board](const char* key, const sim::YamlNode& table) {
    if (sim::YamlNode* own = board->find(key)) {
      if (own->kind != sim::YamlKind::mapping) {
        *own = table;
      }
    } else {
      append(*board, key, table);
    }
  };
  give("arithmetic", k_arithmetic);
  give("program", k_program);
}

}  // namespace

void try_machine(const std::string& input) {
  try {
    sim::YamlNode tree = read_tree(input);
    give_tables(tree);
    const sim::Machine machine = sim::read_machine(tree);
    static_cast<void>(sim::list_parameters(machine));
    const std::string written = sim::write_yaml(sim::write_machine(machine));
    try {
      const sim::Machine again = sim::read_machine(sim::parse_yaml(written, "config.yaml"));
      require(sim::write_yaml(sim::write_machine(again)) == written,
              "the effective configuration of a machine is another one when it is read again");
    } catch (const sim::DescriptionError& error) {
      throw BrokenLaw(std::string{"the effective configuration of a machine is refused: "} +
                      error.what());
    }
  } catch (const sim::DescriptionError&) {
    return;
  }
}

std::vector<std::string> machine_seeds() {
  std::vector<std::string> seeds = texts_below("models/machines", k_most_seed_bytes);
  seeds.push_back(sim::write_yaml(sim::write_machine(sim::default_machine())));
  return seeds;
}

}  // namespace maquette::fuzz
