#include <fmt/format.h>

#include <exception>

#include "sim/command_line/program.hpp"
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
  const std::unique_ptr<CLI::App> program = maquette::sim::declare_program(command, exit_code);
  try {
    program->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program->exit(error) == 0 ? 0 : k_exit_bad_input;
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
