#include "sim/page/assets.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("The program holds the style sheet and every script, byte by byte") {
  const std::filesystem::path room = std::string(MAQUETTE_PROJECT_DIRECTORY) + "/sim/page";
  CHECK(asset("style.css") == content_of(room / "style.css"));
  int scripts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(room / "script")) {
    if (entry.path().extension() == ".js") {
      CHECK(asset(entry.path().filename().string()) == content_of(entry.path()));
      ++scripts;
    }
  }
  CHECK(scripts >= 4);
}

TEST_CASE("The library that draws has its licence beside it") {
  CHECK_THAT(std::string(asset("chart_library.js")), ContainsSubstring("Chart.js v3"));
  CHECK_THAT(std::string(asset("chart_licence.txt")),
             ContainsSubstring("Permission is hereby granted"));
}

TEST_CASE("Style sheet and scripts have no place in the page where they would break it") {
  CHECK(asset("style.css").find_first_of("<&") == std::string_view::npos);
  CHECK_THROWS_AS(asset("nothing.js"), std::logic_error);
}
