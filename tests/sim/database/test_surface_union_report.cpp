#include "sim/database/surface_union_report.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <string>

#include "sim/database/scene_report.hpp"
#include "sim/scene/description_loader.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette;
using namespace maquette::sim;

namespace {

struct Row {
  std::string parent;
  std::string sons;
  double low_r;
  double high_r;
  double low_z;
  double high_z;
};

std::string report_of(const std::string& scene) {
  const std::string directory = data_directory().string();
  const Description description =
      load_description({directory + "/scenes/" + scene, {}, {}, directory});
  const std::string text = surface_union_report(
      packed_scene<float>(description.scene, picture_format_of(description.machine)));
  const std::string whole = scene_report(description.scene, description.machine);
  CHECK(whole.find(text) != std::string::npos);
  return text;
}

std::map<int, Row> rows_of(const std::string& text) {
  const std::string number = " +(-?[0-9.]+) to +(-?[0-9.]+)";
  const std::regex pattern("  +([0-9]+)  +([0-9]+|-)  +([0-9]+, [0-9]+|-)  ([0-9]+[ to0-9]*)" +
                           number + number + "\n");
  std::map<int, Row> rows;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    rows[std::stoi((*match)[1])] = {(*match)[2],
                                    (*match)[3],
                                    std::stod((*match)[5]),
                                    std::stod((*match)[6]),
                                    std::stod((*match)[7]),
                                    std::stod((*match)[8])};
  }
  return rows;
}

TEST_CASE("a shell has a tree of its sections as a solid of revolution has") {
  const std::string text = report_of("primitives/shell.yaml");
  CHECK_THAT(text, Catch::Matchers::ContainsSubstring("a shell: 4 sections, 7 nodes of 16 bytes"));
  CHECK_THAT(text, Catch::Matchers::ContainsSubstring("a shell: 1 sections, 1 nodes"));
}

TEST_CASE("every node of a surface union has its parent, two sons or none, and an extent in its") {
  const std::string text = report_of("photo3.yaml");
  CHECK_THAT(text, Catch::Matchers::ContainsSubstring("15 sections, 29 nodes of 16 bytes"));
  const std::map<int, Row> rows = rows_of(text);
  REQUIRE(rows.size() == 29);
  int leaves = 0;
  for (const auto& [number, row] : rows) {
    INFO(number);
    leaves += row.sons == "-" ? 1 : 0;
    if (row.parent == "-") {
      CHECK(number == 0);
      continue;
    }
    const Row& parent = rows.at(std::stoi(row.parent));
    const std::string name = std::to_string(number);
    const std::size_t comma = parent.sons.find(',');
    CHECK((parent.sons.substr(0, comma) == name || parent.sons.substr(comma + 2) == name));
    CHECK(parent.low_r <= row.low_r);
    CHECK(parent.high_r >= row.high_r);
    CHECK(parent.low_z <= row.low_z);
    CHECK(parent.high_z >= row.high_z);
  }
  CHECK(leaves == 15);
}

TEST_CASE("a scene without surfaces of revolution has no surface unions") {
  CHECK(report_of("photo4.yaml").empty());
}

}  // namespace
