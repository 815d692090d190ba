#pragma once

#include <filesystem>
#include <regex>
#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

namespace maquette::tests {

/// The page that `maquette report` makes of a directory.
inline std::string report_of(const std::filesystem::path& directory) {
  const Outcome outcome = run_maquette("report --quiet " + directory.string());
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.output.empty());
  return content_of(directory / "report.html");
}

/// The page without its styles and scripts, and with a space for each tag.
inline std::string read_by_people(const std::string& page) {
  const std::string shown =
      std::regex_replace(page.substr(0, page.find("<script type=\"importmap\"")),
                         std::regex("<script[^>]*>[^<]*</script>"), " ");
  return std::regex_replace(shown, std::regex("<[^>]*>"), " ");
}

}  // namespace maquette::tests
