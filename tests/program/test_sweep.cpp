#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <regex>
#include <sstream>
#include <thread>
#include <vector>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

namespace {

/// A frame of a few pixels: a point takes milliseconds.
const std::string k_tiny_frame =
    " --set frame_memory.width=32pixels --set frame_memory.height=24pixels ";

std::string sweep_of(const ScratchDirectory& scratch) {
  return "sweep " + scratch.file("small.yaml", k_small_scene) + k_tiny_frame + "--quiet ";
}

Outcome sweep(const ScratchDirectory& scratch, const std::string& options,
              const std::string& directory) {
  return run_maquette(sweep_of(scratch) + options + " --outdir " + (scratch / directory).string());
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& cells = rows.emplace_back();
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) {
      cells.push_back(cell);
    }
  }
  return rows;
}

void check_same_study(const std::filesystem::path& first, const std::filesystem::path& second) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(first)) {
    const auto name = std::filesystem::relative(entry.path(), first);
    if (entry.is_regular_file() && name != "manifest.json") {
      INFO(name.string());
      CHECK(content_of(entry.path()) == content_of(second / name));
    }
  }
}

const std::string k_grid = "--vary processors=1..3 --vary bus.arbitration=priority,round_robin";

}  // namespace

TEST_CASE("A sweep gives one row per point, the same bytes for any way of running it") {
  const ScratchDirectory scratch;
  REQUIRE(sweep(scratch, k_grid + " --jobs 1", "one").exit_code == 0);
  REQUIRE(sweep(scratch, k_grid + " --jobs 3", "three").exit_code == 0);
  check_same_study(scratch / "one", scratch / "three");

  const auto rows = rows_of(content_of(scratch / "one" / "table.csv"));
  REQUIRE(rows.size() == 7);
  CHECK(rows[0][0] == "point");
  CHECK(rows[0][1] == "processors");
  CHECK(rows[4].size() == rows[0].size());
  CHECK((rows[4][0] == "3" && rows[4][1] == "2" && rows[4][2] == "round_robin"));
  CHECK(rows[4][3] == "done");

  for (const char* part : {"--points 3..5", "--task 1 --tasks 2", "--point 0", "--points 0..5"}) {
    REQUIRE(sweep(scratch, k_grid + " " + part, "parts").exit_code == 0);
    CHECK_FALSE(std::filesystem::exists(scratch / "parts" / "table.csv"));
  }
  REQUIRE(run_maquette("merge --quiet " + (scratch / "parts").string()).exit_code == 0);
  check_same_study(scratch / "one", scratch / "parts");
}

TEST_CASE("A point of a sweep has the statistics of the same run") {
  const ScratchDirectory scratch;
  REQUIRE(sweep(scratch, "--vary processors=3", "sweep").exit_code == 0);
  REQUIRE(run_maquette("run " + scratch.file("small.yaml", k_small_scene) + k_tiny_frame +
                       "--set processors=3 --quiet --outdir " + (scratch / "run").string())
              .exit_code == 0);
  const std::string statistics = content_of(scratch / "run" / "stats.json");
  const std::string point = content_of(scratch / "sweep" / "points" / "000000.json");
  CHECK(point.find(statistics.substr(0, statistics.size() - 1)) != std::string::npos);
}

TEST_CASE("The effective study runs again to the same bytes, without the files it came from") {
  const ScratchDirectory scratch;
  const std::string options =
      "--vary machine=ccett-1984,m68020 --vary board.arithmetic=motorola_ffp,mc68881";
  REQUIRE(sweep(scratch, options, "first").exit_code == 0);
  std::filesystem::remove(scratch / "small.yaml");
  REQUIRE(run_maquette("sweep --quiet --sweep " + (scratch / "first" / "study.yaml").string() +
                       " --outdir " + (scratch / "second").string())
              .exit_code == 0);
  check_same_study(scratch / "first", scratch / "second");
}

TEST_CASE("Finished points are kept; failed and missing ones are told and run again") {
  const ScratchDirectory scratch;
  const std::string options = "--vary processors=1..3";
  const auto directory = scratch / "out";
  const auto status = [&](std::size_t point) {
    return rows_of(content_of(directory / "table.csv"))[point + 1][2];
  };
  REQUIRE(sweep(scratch, options, "out").exit_code == 0);
  const std::string table = content_of(directory / "table.csv");
  const auto kept = directory / "points" / "000002.json";
  const auto time = std::filesystem::last_write_time(kept);

  std::filesystem::remove(directory / "points" / "000000.json");
  const auto file = directory / "points" / "000001.json";
  const std::string text = content_of(file);
  std::ofstream(file) << text.substr(0, text.find("\"statistics\""))
                      << "\"failure\": \"the roof fell in\"}";
  const Outcome outcome = run_maquette("merge " + directory.string());
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.output.find("1 points done, 1 failed, 1 missing") != std::string::npos);
  CHECK((status(0) == "missing" && status(1) == "failed" && status(2) == "done"));
  CHECK(content_of(directory / "table.csv").find("the roof fell in") != std::string::npos);

  CHECK(sweep(scratch, options, "out").exit_code == 0);
  CHECK(content_of(directory / "table.csv") == table);
  CHECK(std::filesystem::last_write_time(kept) == time);
}

TEST_CASE("A directory belongs to one study, which may get other plots") {
  const ScratchDirectory scratch;
  REQUIRE(sweep(scratch, "--vary processors=1,2", "out").exit_code == 0);
  const std::string study = content_of(scratch / "out" / "study.yaml");
  for (const char* other :
       {"--vary processors=1,3", "--vary processors=1,2 --set bus.clock=9MHz"}) {
    const Outcome outcome = sweep(scratch, other, "out");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.errors.find("another study") != std::string::npos);
    CHECK(content_of(scratch / "out" / "study.yaml") == study);
  }
}

TEST_CASE("Bad studies are refused before anything is written") {
  const ScratchDirectory scratch;
  struct Case {
    const char* options;
    const char* pattern;
  };
  const std::vector<Case> cases = {
      {"--vary bus.clok=8MHz,9MHz", R"(--vary bus\.clok=8MHz,9MHz:1:5: .*clok.*`clock`)"},
      {"--vary processors=1..3,999", R"(--vary processors=1\.\.3,999:1:17: .*999)"},
      {"--vary bus.clock=8,9MHz", "1:11: .*`8`.*unit"},
      {"--vary board.ram=128KiB,40KiB", R"(small\.yaml:\d+:\d+: )"},
      {"--vary processors=1..2 --vary processors=4", "varied twice"},
      {"--vary processors=1..2 --set processors=4", "cannot be set too"},
      {"--vary processors=1..2 --plot processors,frame.tim_s", "frame.time_s"},
      {"--vary processors=1..2 --point 2", "0 to 1"},
      {"--zip --vary processors=1..2 --vary bus.arbitration=priority", "equally many"},
      {"", "nothing is varied"},
      {"--vary machine=zx81", "zx81.*ccett-1984"},
      {"--vary processors=1..2 --from-environment", "SLURM_ARRAY_TASK_ID"},
  };
  for (const Case& c : cases) {
    const Outcome outcome = sweep(scratch, c.options, "out");
    INFO(c.options << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(std::regex_search(outcome.errors, std::regex(c.pattern)));
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
  }
}

TEST_CASE("A sweep that is killed or interrupted goes on where it ended") {
  const ScratchDirectory scratch;
  const std::string options = sweep_of(scratch) + "--vary \"bus.arbitration_clocks=1..60 clocks\" ";
  const std::string whole = (scratch / "whole").string();
  const std::string broken = (scratch / "broken").string();
  REQUIRE(run_maquette(options + "--outdir " + whole).exit_code == 0);
  for (const int signal : {SIGKILL, SIGINT}) {
    const std::string shell = std::string("exec ") + MAQUETTE_PROGRAM + " " + options +
                              "--jobs 2 --outdir " + broken + " 2>/dev/null";
    const pid_t process = ::fork();
    if (process == 0) {
      ::execl("/bin/sh", "sh", "-c", shell.c_str(), nullptr);
      ::_exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::kill(process, signal);
    int status = 0;
    ::waitpid(process, &status, 0);
    const bool has_finished = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    // On a loaded machine the signal may come before the program listens to any.
    const bool is_killed = WIFSIGNALED(status) && WTERMSIG(status) == signal;
    const bool is_interrupted = signal == SIGINT && WIFEXITED(status) && WEXITSTATUS(status) == 130;
    CHECK((has_finished || is_killed || is_interrupted));
  }
  REQUIRE(run_maquette(options + "--outdir " + broken).exit_code == 0);
  check_same_study(whole, broken);
}

TEST_CASE("Plots asked for on the command line have logarithmic axes and a title") {
  const ScratchDirectory scratch;
  const Outcome outcome = sweep(
      scratch,
      "--vary processors=1,2,4 --plot processors,frame.time_s --log x,y --title 'How it speeds up'",
      "out");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const std::string script =
      content_of(scratch / "out" / "plots" / "frame.time_s-over-processors.gp");
  CHECK(std::regex_search(script, std::regex("How it speeds up")));
  CHECK(std::regex_search(script, std::regex("logscale x")));
  CHECK(std::regex_search(script, std::regex("logscale y")));
  CHECK(sweep(scratch, "--vary processors=1,2 --log z", "other").exit_code != 0);
}
