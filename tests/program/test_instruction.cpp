#include <sstream>
#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

#include <nlohmann/json.hpp>

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

const char* const k_coarse =
    " --set 'frame_memory.width=48 pixels' --set 'frame_memory.height=36 pixels' --quiet --outdir ";

/// A run of the small scene into a folder of the scratch directory.
std::filesystem::path run(const ScratchDirectory& scratch, const std::string& name,
                          const std::string& options) {
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const Outcome outcome =
      run_maquette("run " + scene + " " + options + k_coarse + (scratch / name).string());
  INFO(options << ": " << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return scratch / name;
}

nlohmann::json statistics(const std::filesystem::path& directory) {
  return nlohmann::json::parse(content_of(directory / "stats.json"));
}

/// What all boards together computed after preprocessing.
double computed(const nlohmann::json& statistics) {
  double sum = 0;
  for (const auto& board : statistics["boards"]) {
    sum += board["compute_s"].get<double>() - statistics["frame"]["preprocess_s"].get<double>();
  }
  return sum;
}

TEST_CASE("boards that execute their program make the firmware's picture, whatever their share") {
  const ScratchDirectory scratch;
  const std::string picture = content_of(run(scratch, "counted", "") / "frame.png");
  for (const std::string options :
       {"",
        "--set board.arithmetic=maquette_ffp",
        "--set board.arithmetic=ieee_single",
        "--set allotment.order=interleaved_lines",
        "--set allotment.order=bands",
        "--set allotment.order=tiles",
        "--set allotment.order=interlaced",
        "--set allotment.order=interlaced --set processors=6 --set allotment.columns=2",
        "--set allotment.order=interlaced --set allotment.assignment=on_demand",
        "--set allotment.order=interlaced --set board.pixel_write=line",
        "--set allotment.order=interlaced --set board.arithmetic=ieee_single",
        "--machine own-pixels",
        "--machine own-pixels --set processors=6 --set board.arithmetic=maquette_ffp",
        "--machine own-pixels --set board.database=shared --set bus.level=signal",
        "--set allotment.order=tiles --set allotment.assignment=on_demand",
        "--set allotment.assignment=on_demand",
        "--set board.pixel_write=line",
        "--set processors=1",
        "--set processors=7",
        "--set board.release=block",
        "--set board.database=shared",
        "--set board.database=shared --set allotment.assignment=on_demand",
        "--set board.pixel_write=line --set allotment.order=tiles",
        "--set host.loads_code=false",
        "--machine m68000-12mhz5"}) {
    const auto directory = run(scratch, "executed", "--processor instruction " + options);
    INFO(options);
    CHECK(content_of(directory / "frame.png") == picture);
    CHECK(computed(statistics(directory)) > 0);
  }
}

TEST_CASE("pixels that boards keep take the executed program what they take the counted one") {
  const ScratchDirectory scratch;
  const auto compute = [&](const std::string& options) {
    return computed(statistics(run(scratch, "boards", options)));
  };
  const std::string slow = "--set 'board.ram_write_wait=100 clocks' ";
  const auto gain = [&](const std::string& options) {
    return compute("--set allotment.order=interlaced " + slow + options) -
           compute("--machine own-pixels " + slow + options);
  };
  const std::string executed = "--processor instruction --set board.costs=tables";
  CHECK(gain(executed) == Approx(gain("--set board.costs=tables")).epsilon(1e-6));
}

TEST_CASE("the host loads the same, whether boards execute their program or are counted") {
  const ScratchDirectory scratch;
  for (const std::string options :
       {"", "--set board.arithmetic=maquette_ffp", "--set host.loads_code=false"}) {
    INFO(options);
    const auto counted = statistics(run(scratch, "counted", options));
    const auto executed =
        statistics(run(scratch, "executed", "--processor instruction " + options));
    CHECK(counted["frame"]["load_s"] == executed["frame"]["load_s"]);
  }
}

TEST_CASE("boards that execute their program read a shared database word by word over the bus") {
  const ScratchDirectory scratch;
  const auto bus_of = [&](const std::string& name, const std::string& options) {
    return statistics(run(scratch, name, "--processor instruction " + options))["bus"];
  };
  const auto own = bus_of("own", "");
  const auto shared = bus_of("shared", "--set board.database=shared");
  const auto words = shared["database_words"].get<std::int64_t>();
  CHECK(own["database_words"] == 0);
  CHECK(words > 1000);
  CHECK(shared["transfers"].get<std::int64_t>() == own["transfers"].get<std::int64_t>() + words);
}

TEST_CASE("an executed board that starves is told by its name") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const Outcome outcome = run_maquette(
      "run " + scene +
      " --processor instruction --set allotment.assignment=on_demand --set processors=8"
      " --set 'board.clock=400 MHz'" +
      k_coarse + (scratch / "starving").string());
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.errors, ContainsSubstring("machine.board") && ContainsSubstring("starves"));
}

TEST_CASE("an executed frame is the same bytes from any number of host threads") {
  const ScratchDirectory scratch;
  const std::string claims = "--processor instruction --set allotment.assignment=on_demand ";
  const std::string expected =
      content_of(run(scratch, "one", claims + "--threads 1") / "stats.json");
  for (const std::string threads : {"2", "3", "16"}) {
    CHECK(content_of(run(scratch, threads, claims + "--threads " + threads) / "stats.json") ==
          expected);
  }
}

TEST_CASE("one board computes what four compute together, but for finding the pixels") {
  const ScratchDirectory scratch;
  const double four = computed(statistics(run(scratch, "four", "--processor instruction")));
  const double one =
      computed(statistics(run(scratch, "one", "--processor instruction --set processors=1")));
  CHECK(one == Approx(four).epsilon(1e-3));
}

TEST_CASE("machines whose boards can not execute the program are refused with the reason") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const auto refused = [&](const std::string& options) {
    const Outcome outcome = run_maquette("run " + scene + " --processor instruction " + options +
                                         k_coarse + (scratch / "refused").string());
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(scratch / "refused"));
    return outcome.errors;
  };
  CHECK_THAT(refused("--set board.database=shared --set 'board.database_cache=1 Kbyte'"),
             ContainsSubstring("board.database_cache"));
  CHECK_THAT(refused("--set 'bus.data_width=32 bits'"), ContainsSubstring("bus.data_width"));
  CHECK_THAT(refused("--set board.arithmetic=vax_11_750_fpa"), ContainsSubstring("vax_11_750_fpa"));
  CHECK_THAT(refused("--set board.arithmetic=mc68881"), ContainsSubstring("mc68881"));
  CHECK_THAT(refused("--set board.arithmetic=ieee_single --set board.arithmetic.execution=package"),
             ContainsSubstring("board.arithmetic.execution=costs"));
  CHECK_THAT(refused("--set processors=64"), ContainsSubstring("24 bits of address"));
}

TEST_CASE("boards that have no place in the addresses of an MC68000 are calibrated by one alone") {
  const ScratchDirectory scratch;
  const auto directory = run(scratch, "counted", "--set processors=64");
  CHECK(statistics(directory)["costs"]["from"] == "calibration");
}

TEST_CASE("arithmetic by the host at its exact cost is the executed package at every tick") {
  const ScratchDirectory scratch;
  const std::string scenes = std::string(MAQUETTE_PROJECT_DIRECTORY) + "/scenes/";
  for (const std::string scene :
       {"photo4.yaml", "primitives/prism.yaml", "primitives/revolution.yaml",
        "primitives/shell.yaml", "primitives/terrain.yaml", "effects/facets_gaussian.yaml",
        "effects/orthographic.yaml", "effects/tinted_shadows.yaml"}) {
    const auto result = [&](const std::string& name, const std::string& processor) {
      const std::string directory = (scratch / name).string();
      const Outcome outcome =
          run_maquette("run " + scenes + scene + " --set board.ram=1024KiB " +
                       "--set board.arithmetic=maquette_ffp " + processor + k_coarse + directory);
      INFO(scene << ": " << outcome.errors);
      REQUIRE(outcome.exit_code == 0);
      return scratch / name;
    };
    const std::string executed = "--processor instruction --set board.arithmetic.execution=";
    INFO(scene);
    const auto package = result("package", executed + "package");
    CHECK(content_of(result("exact", executed + "exact") / "stats.json") ==
          content_of(package / "stats.json"));
    CHECK(content_of(result("counted", "") / "frame.png") == content_of(package / "frame.png"));
  }
}

TEST_CASE("the RAM of boards is dumped with a map of what is in it") {
  const ScratchDirectory scratch;
  const auto directory =
      run(scratch, "dumped", "--processor instruction --dump-ram 0 --dump-ram 3");
  const std::string first = content_of(directory / "ram-0.bin");
  const std::string last = content_of(directory / "ram-3.bin");
  CHECK(first.size() == 131072);
  CHECK(last.size() == first.size());
  CHECK_FALSE(std::filesystem::exists(directory / "ram-1.bin"));
  std::istringstream lines(content_of(directory / "ram.map"));
  std::size_t pieces = 0;
  std::size_t end = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t address = std::stoul(line.substr(0, 6), nullptr, 16);
    const std::size_t bytes = std::stoul(line.substr(7, 6), nullptr, 16);
    const std::string name = line.substr(14);
    INFO(line);
    CHECK(address + bytes <= first.size());
    const bool is_piece = name.rfind("  ", 0) == 0;
    if (is_piece || name == "firmware code" || name == "arithmetic package" || name == "database") {
      // What nobody writes is as it was loaded, the same on every board.
      CHECK(first.substr(address, bytes) == last.substr(address, bytes));
      CHECK(first.substr(address, bytes) != std::string(bytes, '\0'));
    }
    if (is_piece) {
      ++pieces;
      CHECK(address >= end);
      end = address + bytes;
    }
    if (name == "task") {
      CHECK(first.substr(address, bytes) != last.substr(address, bytes));
    }
  }
  CHECK(pieces > 50);
}

TEST_CASE("RAM is dumped of boards that there are and that work in it") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const auto refused = [&](const std::string& options) {
    const Outcome outcome =
        run_maquette("run " + scene + " " + options + k_coarse + (scratch / "refused").string());
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(scratch / "refused"));
    return outcome.errors;
  };
  CHECK_THAT(refused("--dump-ram 0"), ContainsSubstring("--processor instruction"));
  CHECK_THAT(refused("--dump-ram 4 --processor instruction"), ContainsSubstring("0 to 3"));
}

}  // namespace
