#include <numeric>

#include "tests/catch.hpp"
#include "tests/program/chrome_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/program/vcd_reader.hpp"

using namespace maquette::tests;

namespace {

constexpr std::int64_t k_line_ps = 64'000'000;

Outcome run_traced(const ScratchDirectory& scratch, const std::string& options) {
  return run_maquette("run " + scratch.file("small.yaml", k_small_scene) +
                      " --set frame_memory.width=96pixels --set frame_memory.height=287pixels "
                      "--set board.clock=50MHz --set processors=3 --quiet --outdir " +
                      (scratch / "run").string() + " " + options);
}

std::string file_in(const ScratchDirectory& scratch, const char* name) {
  return (scratch / name).string();
}

std::int64_t sum_of(const std::vector<Slice>& slices) {
  return std::accumulate(
      slices.begin(), slices.end(), std::int64_t{0},
      [](std::int64_t sum, const Slice& slice) { return sum + slice.to - slice.from; });
}

void check_tiles(const std::vector<Slice>& slices) {
  for (std::size_t i = 1; i < slices.size(); ++i) {
    REQUIRE(slices[i].from == slices[i - 1].to);
    REQUIRE(slices[i].name != slices[i - 1].name);
  }
}

}  // namespace

TEST_CASE("fields, lines and waits of the video reader are in every trace, and are the same") {
  const ScratchDirectory scratch;
  const Outcome outcome =
      run_traced(scratch, "--bus signal --trace-video --trace-window '1 ms..61 ms' --trace " +
                              file_in(scratch, "t.json") + " --trace " + file_in(scratch, "t.vcd") +
                              " --trace-lines " + file_in(scratch, "lines.vcd"));
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const ChromeTraceReader json(content_of(scratch / "t.json"));
  const VcdReader vcd(content_of(scratch / "t.vcd"));
  const VcdReader lines(content_of(scratch / "lines.vcd"));
  const std::vector<Slice> fields = json.slices("video reader", "field");
  const std::vector<Slice> shown = json.slices("video reader", "line");
  const std::vector<Slice> waits = json.slices("video reader", "accesses that wait for a slot");
  REQUIRE(fields.size() >= 3);
  REQUIRE(shown.size() >= 937);
  REQUIRE(waits.size() > 5);
  check_tiles(fields);
  check_tiles(shown);
  CHECK(sum_of(fields) == vcd.last - vcd.first);
  CHECK(sum_of(shown) == vcd.last - vcd.first);
  CHECK(sum_of({shown.begin() + 1, shown.end() - 1}) ==
        k_line_ps * static_cast<std::int64_t>(shown.size() - 2));
  CHECK(sum_of(waits) == vcd.time_with("video_reader.WAIT_n", "0"));
  CHECK(sum_of(waits) == lines.time_with("video_reader.WAITING", "1"));
  for (const Slice& line : shown) {
    const std::int64_t middle = (line.from + line.to) / 2;
    for (const auto* name : {"field", "line", "row"}) {
      INFO(name << " at " << middle);
      const std::string seen = vcd.value(std::string("video_reader.") + name, middle);
      std::string on_lines = lines.value(name == std::string("field")  ? "video_reader.FIELD"
                                         : name == std::string("line") ? "video_reader.LINE"
                                                                       : "video_reader.ROW",
                                         middle);
      if (on_lines == "1111111111111111") {
        on_lines = "z";
      }
      REQUIRE(seen == on_lines);
    }
  }
}

TEST_CASE("looking at the video reader changes no result, at any level that shows one master") {
  const ScratchDirectory scratch;
  REQUIRE(run_traced(scratch, "").exit_code == 0);
  const std::string plain = content_of(scratch / "run" / "stats.json");
  for (const std::string level : {"transaction", "signal"}) {
    const Outcome outcome = run_traced(
        scratch, "--bus " + level + " --trace-video --trace " + file_in(scratch, "t.json"));
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    CHECK(content_of(scratch / "run" / "stats.json") == plain);
  }
}

TEST_CASE("a trace without the flag has no video reader, and the flag alone is refused") {
  const ScratchDirectory scratch;
  REQUIRE(run_traced(scratch, "--trace " + file_in(scratch, "t.vcd")).exit_code == 0);
  CHECK(content_of(scratch / "t.vcd").find("video_reader") == std::string::npos);
  const Outcome refused = run_traced(scratch, "--trace-video");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, Catch::Matchers::ContainsSubstring("allowed: beside --trace FILE"));
}
