#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/fuzz/harness.hpp"

// SystemC's library looks for this function.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }

/// Writes the seeds of a harness into a folder: `write_seeds HARNESS FOLDER`.
int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: write_seeds HARNESS FOLDER\n";
    return 2;
  }
  int number = 0;
  for (const std::string& seed : maquette::fuzz::harness_named(argv[1]).seeds()) {
    const auto file = std::filesystem::path{argv[2]} / ("seed-" + std::to_string(number++));
    std::ofstream{file, std::ios::binary} << seed;
  }
  return 0;
}
