#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/harness.hpp"

// SystemC's library looks for this function; no harness has a simulation.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }

/// What libFuzzer calls with each input; an exception that escapes is a find.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const maquette::fuzz::Harness& harness = maquette::fuzz::harness_named(MAQUETTE_HARNESS);
  harness.try_input(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
