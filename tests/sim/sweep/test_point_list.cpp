#include <set>

#include "sim/sweep/latin_hypercube.hpp"
#include "sim/sweep/point_list.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette::sim;

namespace {

const OwnValues& own_values() {
  static const OwnValues own{load_text(k_rich_scene)};
  return own;
}

Study study_of(StudyDesign design, const std::vector<std::string>& axes) {
  Study study;
  study.design = design;
  for (const std::string& axis : axes) {
    study.axes.push_back(parse_axis(axis));
  }
  return study;
}

std::string row(const PointList& points, int number) {
  std::string text;
  for (const AxisValue* value : points.values(number)) {
    text += (text.empty() ? "" : " ") + (value == nullptr ? "-" : value->text);
  }
  return text;
}

std::string rows(const Study& study) {
  const PointList points{study, own_values()};
  std::string text;
  for (int i = 0; i < points.size(); ++i) {
    text += (i == 0 ? "" : "; ") + row(points, i);
  }
  return text;
}

}  // namespace

TEST_CASE("a grid holds every combination, the first axis varying slowest") {
  CHECK(rows(study_of(StudyDesign::grid, {"processors=1..3", "bus.arbitration=a,b"})) ==
        "1 a; 1 b; 2 a; 2 b; 3 a; 3 b");
  const PointList points{study_of(StudyDesign::grid, {"a=1..7", "b=1..5", "c=1..4"}), own_values()};
  std::set<std::string> seen;
  for (int i = 0; i < points.size(); ++i) {
    seen.insert(row(points, i));
  }
  CHECK(seen.size() == 140);
}

TEST_CASE("paired axes go side by side and need equally many values") {
  CHECK(rows(study_of(StudyDesign::zip, {"a=1..3", "b=x,y,z"})) == "1 x; 2 y; 3 z");
  CHECK_THROWS_WITH(
      rows(study_of(StudyDesign::zip, {"a=1..3", "b=x,y"})),
      Catch::Matchers::ContainsSubstring("--vary b=x,y:1:1: b: 2 values stand here and 3 at a"));
}

TEST_CASE("one at a time starts with the description itself and varies a single axis") {
  CHECK(rows(study_of(StudyDesign::one_at_a_time,
                      {"bus.arbitration_clocks=2..10 clocks", "b=x,y", "c=0.5..1 of 3"})) ==
        "- - -; 2 clocks - -; 10 clocks - -; - x -; - y -; - - 0.5; - - 0.75; - - 1");
}

TEST_CASE("too many points are refused") {
  CHECK_THROWS_AS(rows(study_of(StudyDesign::grid, {"a=1..1001", "b=1..1000"})), DescriptionError);
}

TEST_CASE("a Latin hypercube has one point in each part of every axis") {
  for (const int samples : {1, 2, 7, 100}) {
    const auto shares = latin_hypercube(3, samples, 42);
    REQUIRE(shares.size() == 3);
    for (const auto& axis : shares) {
      std::set<int> parts;
      for (const double share : axis) {
        CHECK(share >= 0);
        CHECK(share < 1);
        parts.insert(static_cast<int>(share * samples));
      }
      CHECK(parts.size() == static_cast<std::size_t>(samples));
    }
  }
  CHECK(latin_hypercube(2, 50, 1) == latin_hypercube(2, 50, 1));
  CHECK(latin_hypercube(2, 50, 1) != latin_hypercube(2, 50, 2));
}

TEST_CASE("a Latin hypercube's points are the same with any compiler") {
  Study study = study_of(StudyDesign::latin_hypercube,
                         {"processors=1..64", "bus.clock=log 4..16 MHz",
                          "frame_memory.access_time=100..500 ns", "bus.arbitration=p,q"});
  study.samples = 3;
  study.seed = 7;
  CHECK(rows(study) ==
        "- - - -; 3 15.2825 MHz 152.993 ns q; 41 7.1508 MHz 274.47 ns q; "
        "46 5.57358 MHz 477.622 ns p");
}

TEST_CASE("a Latin hypercube refuses what it cannot stratify") {
  CHECK_THROWS_AS(rows(study_of(StudyDesign::latin_hypercube, {"a=1..3,5"})), DescriptionError);
  CHECK_THROWS_AS(rows(study_of(StudyDesign::latin_hypercube, {"a=1..3:2"})), DescriptionError);
}
