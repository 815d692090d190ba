#include <nlohmann/json.hpp>
#include <vector>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

TEST_CASE("Measured roots keep their bounds and are the same bytes again") {
  const ScratchDirectory scratch;
  const std::string first = (scratch / "first").string();
  const Outcome outcome = run_maquette("stability --only roots --outdir " + first);
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.output.find("every bound holds") != std::string::npos);
  const std::string text = content_of(scratch / "first" / "stability.json");
  const auto json = nlohmann::json::parse(text);
  CHECK(json["broken_bounds"] == 0);
  CHECK(json["rows"].size() > 100);
  const std::string second = (scratch / "second").string();
  const Outcome again = run_maquette("stability --only roots --quiet --outdir " + second);
  CHECK(again.output.empty());
  CHECK(content_of(scratch / "second" / "stability.json") == text);
}

TEST_CASE("One number type alone is measured alone") {
  const ScratchDirectory scratch;
  const Outcome outcome =
      run_maquette("stability --scalar double --only roots --outdir " + (scratch / "out").string());
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.output.find("float") == std::string::npos);
}

TEST_CASE("Wrong options of stability are refused, and nothing is written") {
  const ScratchDirectory scratch;
  const std::vector<std::string> wrong = {"--only rots", "--scalar half",
                                          "--scenes " + (scratch / "none").string()};
  for (const std::string& options : wrong) {
    const Outcome outcome =
        run_maquette("stability " + options + " --outdir " + (scratch / "out").string());
    CAPTURE(options);
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(outcome.errors.empty());
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
  }
}
