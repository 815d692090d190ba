#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "firmware/arithmetic/stop_request.hpp"
#include "sim/command_line/common_options.hpp"
#include "sim/command_line/program.hpp"
#include "sim/command_line/standard_streams.hpp"
#include "sim/report/remark.hpp"
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

/// What was printed is a result: a full device or a closed pipe must not pass for success.
int flushed(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
    return exit_code;
  }
  maquette::sim::remark(
      fmt::format("maquette: standard output cannot be written: {}\n", std::strerror(errno)));
  return k_exit_failure;
}

}  // namespace

int main(int argc, char** argv) {
  using maquette::sim::remark;
  maquette::sim::occupy_closed_streams();
  try {
    return flushed(run_program(argc, argv));
  } catch (const maquette::sim::DescriptionError& error) {
    remark(fmt::format("{}\n", error.what()));
    return k_exit_bad_input;
  } catch (const maquette::firmware::StopRequested&) {
    remark("interrupted before the simulation began; nothing is written\n");
    return maquette::sim::k_exit_interrupted;
  } catch (const std::exception& error) {
    remark(fmt::format("maquette: {}\n", error.what()));
    return k_exit_failure;
  }
}

// SystemC's library looks for this function in its own main, which this program replaces.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }
