#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

// SystemC's library brings a main that looks for this function; the tests have their own main.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }
