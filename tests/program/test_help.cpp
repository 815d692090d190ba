#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("the help lists every command, and each explains itself") {
  const Outcome help = run_maquette("--help");
  CHECK(help.exit_code == 0);
  for (const std::string command :
       {"run", "describe", "sweep", "merge", "accuracy", "compare", "stability", "report"}) {
    INFO(command);
    CHECK_THAT(help.output, ContainsSubstring("\n  " + command + " "));
    const Outcome own = run_maquette(command + " --help");
    CHECK(own.exit_code == 0);
    CHECK_THAT(own.output, ContainsSubstring("Usage: maquette " + command));
    CHECK_THAT(own.output, ContainsSubstring("--"));
    CHECK(own.errors.empty());
  }
}

TEST_CASE("a command is needed, and one that there is") {
  for (const char* wrong : {"", "simulate scenes/photo4.yaml"}) {
    const Outcome outcome = run_maquette(wrong);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.output.empty());
    CHECK_FALSE(outcome.errors.empty());
  }
}

TEST_CASE("the version is told with the revision") {
  CHECK_THAT(run_maquette("--version").output, ContainsSubstring("maquette 1."));
}

TEST_CASE("the keys of every part are explained, and unknown parts answered with those there are") {
  const Outcome unknown = run_maquette("describe --keys revolutoin");
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.errors, ContainsSubstring("did you mean `revolution`?"));
  for (const char* part : {"revolution", "patches", "surface", "light", "view", "study", "plot"}) {
    INFO(part);
    const Outcome outcome = run_maquette(std::string("describe --keys ") + part);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.output, ContainsSubstring("needed") && ContainsSubstring("Example: "));
  }
}
