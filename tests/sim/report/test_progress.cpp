#include <chrono>

#include "sim/report/progress.hpp"
#include "tests/catch.hpp"

using maquette::sim::progress_line;
using namespace std::chrono_literals;

TEST_CASE("a progress line tells simulated time, rate and time left") {
  CHECK(progress_line(105s, 0.25, 0.5) ==
        "[######..................]  25 %  1 min 45.0 s simulated, 210 times real time, 0:01 left");
  CHECK(progress_line(420s, 1, 100) ==
        "[########################] 100 %  7 min 00.0 s simulated, 4 times real time, 0:00 left");
}

TEST_CASE("a progress line at the start and outside of the range") {
  CHECK(progress_line(0s, 0, 0) == "[........................]   0 %  0 s simulated");
  CHECK(progress_line(1s, 1.5, 1) == progress_line(1s, 1, 1));
  CHECK(progress_line(1s, -1, 1) == progress_line(1s, 0, 1));
}

TEST_CASE("a progress line of checks tells how many are done and which one runs") {
  CHECK(maquette::sim::check_progress_line(3, 12, "float roots", 61) ==
        "[######..................] 3 of 12 checks, 1:01, now float roots");
}
