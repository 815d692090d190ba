#define CATCH_CONFIG_RUNNER
#include "tests/catch.hpp"

// SystemC's library brings a main that looks for this function; the tests have their own main.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }

int main(int argc, char** argv) { return Catch::Session().run(argc, argv); }
