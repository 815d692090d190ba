#include <cstdio>
#include <exception>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/program.hpp"
#include "sim/report/run_directory.hpp"
#include "tools/documentation/documents.hpp"

// Writes the manual page and the completions of maquette, made from the options that it declares.
// Usage: documentation DIRECTORY

int main(int argc, char** argv) {
  using namespace maquette::documentation;
  if (argc != 2) {
    std::fputs("usage: documentation DIRECTORY\n", stderr);
    return 2;
  }
  try {
    int exit_code = 0;
    const std::vector<std::string> command;
    const auto declared = maquette::sim::declare_program(command, exit_code);
    const DocumentedProgram program = documented(*declared, maquette::sim::data_directory());
    maquette::sim::write_files(argv[1], {{"maquette.1", man_page(program)},
                                         {"maquette.bash", bash_completion(program)},
                                         {"_maquette", zsh_completion(program)},
                                         {"maquette.fish", fish_completion(program)}});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "documentation: %s\n", error.what());
    return 1;
  }
  return 0;
}

// SystemC's library looks for this function in its own main, which this program replaces.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }
