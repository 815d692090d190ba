#include "models/machine/unique_names.hpp"

#include <string>
#include <systemc>

#include "tests/catch.hpp"

namespace {

struct Module : sc_core::sc_module {
  explicit Module(const sc_core::sc_module_name& name) : sc_module(name) {}
};

TEST_CASE("the second module of a name is an error") {
  maquette::models::require_unique_names();
  const Module first("twin");
  std::string message;
  try {
    const Module second("twin");
  } catch (const sc_core::sc_report& report) {
    message = report.what();
  }
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring("twin"));
}

}  // namespace
