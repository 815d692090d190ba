#include "sim/command_line/program.hpp"

#include "sim/command_line/accuracy_command.hpp"
#include "sim/command_line/compare_command.hpp"
#include "sim/command_line/describe_command.hpp"
#include "sim/command_line/report_command.hpp"
#include "sim/command_line/run_command.hpp"
#include "sim/command_line/stability_command.hpp"
#include "sim/command_line/sweep_command.hpp"
#include "sim/command_line/version.hpp"

namespace maquette::sim {

std::unique_ptr<CLI::App> declare_program(const std::vector<std::string>& command, int& exit_code) {
  auto program = std::make_unique<CLI::App>(
      "maquette simulates the ray-casting prototype that CCETT built in 1984: four KVM02 boards on "
      "a VERSAbus, a frame memory and a 625-line video reader.",
      "maquette");
  program->require_subcommand(1);
  program->set_version_flag("--version",
                            std::string("maquette ") + version() + " (" + revision() + ")",
                            "version and revision of the program");
  add_run_command(*program, command, exit_code);
  add_describe_command(*program);
  add_sweep_commands(*program, command, exit_code);
  add_accuracy_command(*program, command, exit_code);
  add_compare_command(*program, exit_code);
  add_report_command(*program);
  add_stability_command(*program, command, exit_code);
  return program;
}

}  // namespace maquette::sim
