#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <string>
#include <vector>

#include "sim/command_line/accuracy_command.hpp"
#include "sim/command_line/compare_command.hpp"
#include "sim/command_line/describe_command.hpp"
#include "sim/command_line/run_command.hpp"
#include "sim/command_line/stability_command.hpp"
#include "sim/command_line/sweep_command.hpp"
#include "sim/yaml/description_error.hpp"

namespace {

constexpr int k_exit_bad_input = 2;
constexpr int k_exit_failure = 1;

int run_program(int argc, char** argv) {
  const std::vector<std::string> command = [argc, argv] {
    std::vector<std::string> words = {"maquette"};
    words.insert(words.end(), argv + 1, argv + argc);
    return words;
  }();
  int exit_code = 0;
  CLI::App program{
      "maquette simulates the ray-casting prototype that CCETT built in 1984: four KVM02 boards on "
      "a VERSAbus, a frame memory and a 625-line video reader.",
      "maquette"};
  program.require_subcommand(1);
  program.set_version_flag("--version", MAQUETTE_VERSION);
  maquette::sim::add_run_command(program, command, exit_code);
  maquette::sim::add_describe_command(program);
  maquette::sim::add_sweep_commands(program, command, exit_code);
  maquette::sim::add_accuracy_command(program, command, exit_code);
  maquette::sim::add_compare_command(program, exit_code);
  maquette::sim::add_stability_command(program, command, exit_code);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : k_exit_bad_input;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const maquette::sim::DescriptionError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return k_exit_bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "maquette: {}\n", error.what());
    return k_exit_failure;
  }
}

// SystemC's library looks for this function in its own main, which this program replaces.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }
