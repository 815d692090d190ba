#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;
using Json = nlohmann::json;

namespace {

Json described(const std::string& what) {
  const Outcome outcome = run_maquette("describe " + what + " --format json");
  INFO(what << "\n" << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.output);
}

std::vector<std::string> parts() {
  const std::string errors = run_maquette("describe --keys nothing-of-this-name").errors;
  std::vector<std::string> names;
  std::istringstream list(errors.substr(errors.find("allowed: ") + 9));
  for (std::string name; list >> name;) {
    names.push_back(name.substr(0, name.find(',')));
  }
  return names;
}

std::string example_of(const std::string& part) {
  const std::string text = run_maquette("describe --keys " + part).output;
  const std::size_t start = text.find("Example: ");
  REQUIRE(start != std::string::npos);
  return text.substr(start + 9, text.find('\n', start) - start - 9);
}

std::string key_of(const std::string& line) { return line.substr(0, line.find(':')); }

/// The example among what else a scene needs.
std::string scene_with(const std::string& example) {
  const std::map<std::string, std::string> needed{
      {"view", "view: {eye: [0, -6, 3], target: [0, 0, 0], field_of_view: 30 deg}"},
      {"surfaces", "surfaces: {red: {diffuse: [0.8, 0.1, 0.1]}}"},
      {"object", "object: {sphere: {radius: 1}, surface: red}"}};
  std::string text = "name: example\n" + example + "\n";
  for (const auto& [key, line] : needed) {
    text += key == key_of(example) ? "" : line + "\n";
  }
  return text;
}

/// A shipped cost table with the example in the place of its own entry.
std::string table_with(const std::string& example, const std::string& table) {
  std::istringstream lines(content_of(std::filesystem::path(MAQUETTE_PROJECT_DIRECTORY) / table));
  std::string text;
  bool is_left_out = false;
  for (std::string line; std::getline(lines, line);) {
    is_left_out = line.empty() || line[0] != ' ' ? key_of(line) == key_of(example) : is_left_out;
    text += is_left_out ? "" : line + "\n";
  }
  return text + example + "\n";
}

std::string command_of(const std::string& part, const std::string& example,
                       const ScratchDirectory& scratch) {
  const std::string base = "name: example\nscene: photo4\nvary: {processors: 1..8}\n";
  if (part == "study") {
    return scratch.file("study.yaml", example);
  }
  if (part == "plot" || part == "column") {
    return scratch.file("study.yaml", base + example + "\n");
  }
  if (part == "arithmetic") {
    return "photo4 --set board.arithmetic=" +
           scratch.file("table.yaml", table_with(example, "models/arithmetic/mc68881.yaml"));
  }
  if (part == "program") {
    return "photo4 --set board.program=" +
           scratch.file("table.yaml", table_with(example, "models/program/mc68000.yaml"));
  }
  if (part == "unit") {
    return scratch.file("machine.yaml", "name: example\nprocessors: 4\n" + example + "\n");
  }
  return scratch.file("scene.yaml", scene_with(example));
}

}  // namespace

TEST_CASE("the example of every part of descriptions is one that is read") {
  const std::vector<std::string> names = parts();
  REQUIRE(names.size() > 12);
  for (const std::string& part : names) {
    const ScratchDirectory scratch;
    const std::string example = example_of(part);
    const bool is_file = example.find(".yaml") == example.size() - 5;
    const std::string command =
        is_file ? (std::filesystem::path(MAQUETTE_PROJECT_DIRECTORY) / example).string()
                : command_of(part, example, scratch);
    const Outcome outcome = run_maquette("describe " + command);
    INFO(part << "\n" << example << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 0);
    CHECK(described("--keys " + part).is_array());
  }
}

TEST_CASE("the paths of a scene's objects are those that --set takes, with their values") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  int objects = 0;
  for (const Json& row : described(scene)) {
    const std::string path = row["path"];
    if (path.rfind("object.", 0) != 0) {
      continue;
    }
    ++objects;
    const std::string value =
        row["value"].is_string() ? row["value"].get<std::string>() : row["value"].dump();
    const Outcome outcome =
        run_maquette("describe " + scene + " --all --set '" + path + "=" + value + "'");
    INFO(path << "=" << value << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.output, ContainsSubstring("  " + path + "  "));
  }
  CHECK(objects > 8);
  const Outcome none = run_maquette("describe " + scene + " --set object.union.9.box.size=1");
  CHECK(none.exit_code == 2);
}

TEST_CASE("a scene of many objects shows the first ones, and all when asked") {
  const ScratchDirectory scratch;
  std::string text =
      "name: many\nview: {eye: [0, -6, 3], target: [0, 0, 0], field_of_view: 30 deg}\n"
      "surfaces: {red: {diffuse: [1, 0, 0]}}\nobject:\n  surface: red\n  union:\n";
  for (int i = 0; i < 50; ++i) {
    text += "    - sphere: {radius: 1}\n";
  }
  const std::string scene = scratch.file("many.yaml", text);
  const std::string last = "object.union.49.sphere.radius";
  const std::string some = run_maquette("describe " + scene).output;
  CHECK(some.find(last) == std::string::npos);
  CHECK_THAT(some, ContainsSubstring("and 31 more with --all"));
  CHECK_THAT(run_maquette("describe " + scene + " --all").output, ContainsSubstring(last));
}

TEST_CASE("a scene is described in groups that fit a screen, of what it gives") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  for (const std::string options : {"", " --machine m68020", " --set processors=9"}) {
    const Outcome outcome = run_maquette("describe " + scene + options);
    REQUIRE(outcome.exit_code == 0);
    std::istringstream lines(outcome.output);
    int of_group = 0;
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      CHECK(line.size() <= 100);
      of_group = line.empty() ? 0 : of_group + 1;
      CHECK(of_group <= 24);
    }
  }
  const std::string plain = run_maquette("describe " + scene).output;
  CHECK_THAT(plain, ContainsSubstring("other than the prototype in nothing"));
  CHECK_THAT(plain, ContainsSubstring("  view.eye            [0, -6, 3]"));
  CHECK_THAT(plain, !ContainsSubstring("view.projection"));
  CHECK_THAT(run_maquette("describe " + scene + " --all").output,
             ContainsSubstring("view.projection"));
  CHECK_THAT(run_maquette("describe " + scene + " --set processors=9").output,
             ContainsSubstring("  processors  9  number of boards"));
}

TEST_CASE("the name of a part means its keys, unless a file is called so") {
  for (const std::string& part : parts()) {
    INFO(part);
    CHECK(run_maquette("describe " + part).output ==
          run_maquette("describe --keys " + part).output);
  }
  CHECK_THAT(run_maquette(std::string("describe " MAQUETTE_PROJECT_DIRECTORY
                                      "/scenes/primitives/torus.yaml"))
                 .output,
             !ContainsSubstring("Example: "));
}

TEST_CASE("the name of a cost table means its figures, as a board that names it has them") {
  const std::filesystem::path models = MAQUETTE_PROJECT_DIRECTORY "/models";
  for (const std::string kind : {"arithmetic", "program"}) {
    for (const auto& file : std::filesystem::directory_iterator(models / kind)) {
      const std::string name = file.path().stem().string();
      INFO(kind << " " << name);
      if (std::filesystem::exists(models / "machines" / file.path().filename())) {
        CHECK_THAT(run_maquette("describe " + name).output, ContainsSubstring("Machine " + name));
        continue;
      }
      std::map<std::string, Json> rows;
      for (const Json& row : described(name)) {
        rows[row["operation"]] = row;
      }
      int figures = 0;
      for (const Json& row : described("ccett-1984 --set board." + kind + "=" + name)) {
        const std::string path = row["path"];
        const std::string start = "board." + kind + ".";
        const std::size_t dot = path.rfind('.');
        const std::string column = path.substr(dot + 1);
        if (path.find(start) == 0 && (column == "clocks" || column == "reads")) {
          CHECK(rows.at(path.substr(start.size(), dot - start.size()))[column] == row["value"]);
          ++figures;
        }
      }
      CHECK(figures >= 34);
      CHECK_THAT(run_maquette("describe " + name).output, ContainsSubstring("Cost table " + name));
    }
  }
  CHECK(described("motorola_ffp --set board.arithmetic.add.clocks=77").front()["clocks"] == 77);
  CHECK(run_maquette("describe motorola_ffp --set board.arithmetic.add.clocks=-1").exit_code == 2);
}

TEST_CASE("a study is described with what it varies and the columns that it derives") {
  const Outcome outcome = run_maquette("describe bus_saturation");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  for (const char* text : {"28 points", "board.clock", "speed_up of frame.time_s over processors",
                           "bus.occupied", "a series for each board.clock"}) {
    CHECK_THAT(outcome.output, ContainsSubstring(text));
  }
  std::map<std::string, std::string> kinds;
  for (const Json& row : described("bus_saturation")) {
    kinds[row["column"]] = row["kind"];
  }
  CHECK(kinds.at("speed_up") == "derived");
  CHECK(kinds.at("processors") == "varied");
  CHECK(kinds.at("bus.shares.handover") == "of a run");
}

TEST_CASE("what varies the boards and derives nothing gets speed-up and efficiency") {
  const ScratchDirectory scratch;
  const std::string study =
      scratch.file("study.yaml", "{name: boards, scene: photo4, vary: {processors: 1..8}}");
  CHECK_THAT(run_maquette("describe " + study).output,
             ContainsSubstring("efficiency of frame.time_s over processors"));
}

TEST_CASE("tables are printed for programs: JSON with numbers, CSV with the same cells") {
  const Json maps = described("--maps");
  REQUIRE(maps.size() > 10);
  CHECK(maps[0].contains("title"));
  const std::string csv = run_maquette("describe --statistics --format csv").output;
  CHECK(csv.rfind("key,unit,meaning\n", 0) == 0);
  CHECK_THAT(csv, ContainsSubstring("\nbus.occupied,"));
  const Json machine = described("ccett-1984");
  bool has_processors = false;
  for (const Json& row : machine) {
    has_processors = has_processors || (row["path"] == "processors" && row["value"] == 4);
  }
  CHECK(has_processors);
  const Outcome wrong = run_maquette("describe ccett-1984 --format xml");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.errors, ContainsSubstring("--format"));
}

TEST_CASE("a comparison and a sweep print their tables alone in the format that is asked for") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string run = "run " + scene + k_small_frame + "--quiet --outdir ";
  const std::string first = (scratch / "first").string();
  const std::string second = (scratch / "second").string();
  REQUIRE(run_maquette(run + first).exit_code == 0);
  REQUIRE(run_maquette(run + second + " --set processors=3").exit_code == 0);
  const Outcome compared = run_maquette("compare " + first + " " + second + " --format json");
  CHECK(compared.exit_code == 1);
  bool has_processors = false;
  for (const Json& row : Json::parse(compared.output)) {
    has_processors = has_processors || (row["path"] == "machine.processors" && row["first"] == 4 &&
                                        row["second"] == 3 && row["relative"] == -0.25);
  }
  CHECK(has_processors);
  const Outcome swept =
      run_maquette("sweep " + scene + k_small_frame +
                   "--vary processors=1,2 --format csv --outdir " + (scratch / "sweep").string());
  INFO(swept.errors);
  REQUIRE(swept.exit_code == 0);
  CHECK(swept.output == content_of(scratch / "sweep" / "table.csv"));
}
