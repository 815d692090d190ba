#include <nlohmann/json.hpp>

#include "sim/report/seconds.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using maquette::models::Duration;

namespace {

/// Runs the small scene and returns its run directory.
std::filesystem::path run_small(const ScratchDirectory& scratch, const std::string& name,
                                const std::string& options) {
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::filesystem::path directory = scratch / name;
  const Outcome outcome = run_maquette("run " + scene + k_small_frame + "--quiet --outdir " +
                                       directory.string() + " " + options);
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return directory;
}

/// Exact picoseconds of a time in stats.json, whose digits a double would round.
Duration exact_time(const std::string& text) {
  const auto time = maquette::sim::parse_seconds(text);
  REQUIRE(time.has_value());
  return *time;
}

/// The text of a number in stats.json behind a key, searched from an offset on.
std::string number_behind(const std::string& text, const std::string& key, std::size_t& offset) {
  const std::string quoted = "\"" + key + "\":";
  const std::size_t at = text.find(quoted, offset);
  REQUIRE(at != std::string::npos);
  const std::size_t start = text.find_first_not_of(' ', at + quoted.size());
  const std::size_t end = text.find_first_of(",\n }", start);
  offset = end;
  return text.substr(start, end - start);
}

void check_same_results(const std::filesystem::path& first, const std::filesystem::path& second) {
  for (const char* name : {"frame.png", "stats.json", "config.yaml"}) {
    INFO(name);
    CHECK(content_of(first / name) == content_of(second / name));
    CHECK_FALSE(content_of(first / name).empty());
  }
}

}  // namespace

TEST_CASE("A board's states sum to the frame time in whole picoseconds") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run", "--set processors=3");
  const std::string stats = content_of(directory / "stats.json");
  std::size_t offset = 0;
  const Duration frame_time = exact_time(number_behind(stats, "time_s", offset));
  CHECK(frame_time.count() > 0);
  for (int board = 0; board < 3; ++board) {
    Duration sum{};
    for (const char* state : {"compute_s", "wait_grant_s", "transfer_s", "idle_s"}) {
      sum += exact_time(number_behind(stats, state, offset));
    }
    CHECK(sum == frame_time);
  }
}

TEST_CASE("Every pixel of the useful zone is synthesised once, by one board") {
  const ScratchDirectory scratch;
  for (const char* order :
       {"interleaved_pixels", "interleaved_lines", "bands", "tiles", "interlaced"}) {
    INFO(order);
    const auto directory = run_small(scratch, order, std::string("--set allotment.order=") + order);
    const auto stats = nlohmann::json::parse(content_of(directory / "stats.json"));
    const auto& zone = stats["useful_zone"];
    const int pixels = zone["width"].get<int>() * zone["height"].get<int>();
    int of_boards = 0;
    for (const auto& board : stats["boards"]) {
      of_boards += board["pixels"].get<int>();
    }
    CHECK(pixels > 0);
    CHECK(of_boards == pixels);
    CHECK(stats["frame"]["pixels_synthesised"] == pixels);
    CHECK(stats["rays"]["primary"] == pixels);
    CHECK(stats["bus"]["transfers"] == 2 * pixels);
    CHECK(stats["partial"] == false);
  }
}

TEST_CASE("The rays of a pixel go beyond 16 bits, each once") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("glass.yaml", R"(name: glass
view: {eye: [0, -10, 1], target: [0, 0, 1], up: [0, 0, 1], field_of_view: 40 deg}
lights: {key: {position: [7, -10, 11], intensity: [2, 2, 2]}}
ray_tree: {depth: 22, minimum_weight: 0}
surfaces: {glass: {specular: 1, transparent: true, index: 1.5}}
object:
  union:
    - {box: {size: [100, 0.3, 100]}, surface: glass}
    - {box: {size: [100, 0.3, 100]}, surface: glass, place: {translate: [0, 1, 0]}}
)");
  const Outcome outcome =
      run_maquette("run " + scene +
                   " --quiet --set board.costs=tables --set 'frame_memory.width=1 pixel' --set "
                   "'frame_memory.height=1 pixel' --outdir " +
                   (scratch / "out").string());
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const auto stats = nlohmann::json::parse(content_of(scratch / "out" / "stats.json"));
  const auto& rays = stats["rays"];
  CHECK(rays["shadow"].get<std::int64_t>() > 65535);
  CHECK(rays["total"].get<std::int64_t>() - rays["shadow"].get<std::int64_t>() ==
        stats["work"]["ray"].get<std::int64_t>());
  CHECK(rays["shadow"] == stats["work"]["shadow_ray"]);
}

TEST_CASE("The number of host threads changes no byte") {
  const ScratchDirectory scratch;
  const auto one = run_small(scratch, "one", "--threads 1");
  for (const int threads : {2, 3, 7}) {
    const std::string name = "threads" + std::to_string(threads);
    check_same_results(one, run_small(scratch, name, "--threads " + std::to_string(threads)));
  }
}

TEST_CASE("The effective configuration run again gives the same bytes") {
  const ScratchDirectory scratch;
  const auto first = run_small(scratch, "first",
                               "--set processors=2 --set lights.key.intensity=[1,2,3] "
                               "--set bus.arbitration=round_robin");
  const auto second = scratch / "second";
  const Outcome outcome = run_maquette("run " + (first / "config.yaml").string() +
                                       " --quiet --outdir " + second.string());
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  check_same_results(first, second);
  CHECK(run_maquette("compare " + first.string() + " " + second.string()).exit_code == 0);
}

TEST_CASE("The picture does not depend on the machine, the time does") {
  const ScratchDirectory scratch;
  const auto four = run_small(scratch, "four", "");
  const auto one = run_small(scratch, "one", "--set processors=1 --set board.clock=12MHz");
  CHECK(content_of(four / "frame.png") == content_of(one / "frame.png"));
  CHECK(content_of(four / "stats.json") != content_of(one / "stats.json"));
  const Outcome comparison = run_maquette("compare " + four.string() + " " + one.string());
  CHECK(comparison.exit_code == 1);
  CHECK(comparison.output.find("processors") != std::string::npos);
}

TEST_CASE("Snapshots grow from the background to the finished frame") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run",
                                   "--snapshot 0s --snapshot '5 s' --snapshot 100000s "
                                   "--snapshot-shown 100000s --snapshot-shown 0s");
  const std::string last = content_of(directory / "frame.png");
  CHECK(content_of(directory / "snapshot-100000s.png") == last);
  CHECK(content_of(directory / "snapshot-shown-100000s.png") == last);
  CHECK(content_of(directory / "snapshot-0s.png") ==
        content_of(directory / "snapshot-shown-0s.png"));
  CHECK(content_of(directory / "snapshot-0s.png") != content_of(directory / "snapshot-5s.png"));
  CHECK(content_of(directory / "snapshot-5s.png") != last);
}

TEST_CASE("A run directory holds nothing of the host but in its manifest") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run", "");
  for (const char* name : {"stats.json", "config.yaml"}) {
    CHECK(content_of(directory / name).find(scratch.path().string()) == std::string::npos);
  }
  const auto manifest = nlohmann::json::parse(content_of(directory / "manifest.json"));
  CHECK(manifest.contains("command"));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    static_cast<void>(entry);
    ++files;
  }
  CHECK(files == 4);
}

TEST_CASE("What cannot be printed is an error") {
  const ScratchDirectory scratch;
  const std::string program = MAQUETTE_PROGRAM;
  const std::string errors = (scratch / "errors").string();
  for (const char* arguments : {" describe photo4", " --help", " --version"}) {
    INFO(arguments);
    const int status = std::system((program + arguments + " >/dev/full 2>" + errors).c_str());
    CHECK(WEXITSTATUS(status) == 1);
    CHECK_THAT(content_of(errors), Catch::Matchers::ContainsSubstring("No space left"));
  }
}

TEST_CASE("An interrupted run ends with the statistics so far, marked partial") {
  const ScratchDirectory scratch;
  const std::string directory = (scratch / "run").string();
  // The workplace appears when the simulation begins; glass takes long enough to be found at work,
  // and costs of tables are not told by pixels before it.
  const std::string command =
      std::string(MAQUETTE_PROGRAM) + " run " + MAQUETTE_PROJECT_DIRECTORY +
      "/scenes/photo2.yaml --threads 1 --quiet --set board.costs=tables --outdir " + directory +
      " & pid=$!; until ls -d " + (scratch / ".run.unfinished-*").string() +
      " >/dev/null 2>&1 || ! kill -0 $pid; do sleep 0.02; done; sleep 0.05; kill -INT $pid; "
      "wait $pid";
  const int status = std::system(command.c_str());
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 130);
  const auto stats = nlohmann::json::parse(content_of(scratch / "run" / "stats.json"));
  CHECK(stats["partial"] == true);
  CHECK(stats["end_reason"] == "interrupted");
  CHECK(stats["frame"]["pixels_synthesised"] <
        stats["useful_zone"]["width"].get<int>() * stats["useful_zone"]["height"].get<int>());
}
