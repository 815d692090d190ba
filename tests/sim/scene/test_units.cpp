#include <string>

#include "sim/machine/machine_description.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

/// Function units in descriptions of machines.

namespace maquette::sim {
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

/// The machine stands in line 4.
std::string with_machine(const std::string& machine) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5}}\n"
         "object: {sphere: {radius: 1}, surface: red}\n"
         "machine: " +
         machine + "\n";
}

std::string configuration(const Description& description) {
  return effective_configuration(description.scene, description.machine);
}

const models::FunctionUnitParameters& unit_of(const Description& description,
                                              models::UnitKind kind) {
  return description.machine.parameters.units.kinds[static_cast<std::size_t>(kind)];
}

}  // namespace

TEST_CASE("a kind of units that is described has one unit, as the boards") {
  const Description description = load_text(with_machine("{name: one, units: {intersection: {}}}"));
  CHECK(unit_of(description, models::UnitKind::intersection).number == 1);
  CHECK_FALSE(unit_of(description, models::UnitKind::intersection).clock_hz);
  CHECK(unit_of(description, models::UnitKind::photometry).number == 0);
  CHECK(description.machine.parameters.units.in_flight == 1);
}

TEST_CASE("units stand in the effective configuration only where there are some") {
  const Description plain =
      load_text(with_machine("ccett-1984"), {"units.in_flight=3", "units.extents.number=0"});
  CHECK_FALSE(models::has_units(plain.machine.parameters.units));
  const std::string text = write_yaml(write_machine(plain.machine));
  CHECK_THAT(text, !ContainsSubstring("units:"));
  const Description some = load_text(with_machine("ccett-1984"),
                                     {"units.in_flight=2", "units.photometry.clock=64 MHz",
                                      "units.photometry.choice=by_pixel", "board.ram=256 KiB"});
  const YamlNode written = write_machine(some.machine);
  const Machine again = read_machine(written);
  CHECK(write_yaml(write_machine(again)) == write_yaml(written));
  CHECK(again.parameters.units.in_flight == 2);
  CHECK_THAT(write_yaml(written),
             ContainsSubstring("photometry:") && !ContainsSubstring("extents:"));
}

TEST_CASE("units that make no machine are refused with their place") {
  CHECK_THAT(error_of(with_machine("{name: one, units: {intersector: {}}}")),
             StartsWith("scene.yaml:4:") && ContainsSubstring("unknown key `intersector`"));
  CHECK_THAT(error_of(with_machine("{name: one, units: {intersection: {number: 257}}}")),
             StartsWith("scene.yaml:4:") && ContainsSubstring("256"));
  CHECK_THAT(error_of(with_machine("{name: one, units: {intersection: {queue: 0}}}")),
             StartsWith("scene.yaml:4:"));
  CHECK_THAT(
      error_of(with_machine("{name: one, units: {in_flight: 3, extents: {}, photometry: {}}}")),
      StartsWith("scene.yaml:4:") && ContainsSubstring("units.in_flight: 12 pixels") &&
          ContainsSubstring("up to 2 or a longer queue"));
  CHECK_THAT(
      error_of(with_machine("{name: one, processors: 12, units: {extents: {}, photometry: {}}}")),
      ContainsSubstring("fewer boards or a longer queue"));
  const auto refused = [](const std::string& rest) {
    return error_of(with_machine("{name: one, units: {extents: {}}, " + rest + "}"));
  };
  CHECK_THAT(refused("board: {database: shared}"), ContainsSubstring("own_copy is allowed"));
  CHECK_THAT(refused("board: {pixel_write: line}"), ContainsSubstring("pixel is allowed"));
  CHECK_THAT(refused("frame_memory: {ports: 2}"), ContainsSubstring("1 is allowed"));
  CHECK(refused("frame_memory: {place: boards}, allotment: {order: interlaced}").empty());
  CHECK_THAT(refused("host: {place: {level: 1, position: 4}}"),
             ContainsSubstring("extents unit 0 is at level 1, position 4"));
  CHECK(refused("processors: 3").empty());
}

TEST_CASE("a unit's own cost tables are read, kept apart from the boards', and written again") {
  const Description description = load_text(
      with_machine("ccett-1984"),
      {"units.intersection.arithmetic=microprogrammed", "units.intersection.program=mc68020",
       "units.photometry.number=2", "units.intersection.arithmetic.add.clocks=7"});
  const Machine& machine = description.machine;
  const auto& own = unit_of(description, models::UnitKind::intersection).costs;
  REQUIRE(own);
  CHECK_FALSE(unit_of(description, models::UnitKind::photometry).costs);
  const CostTables& tables =
      machine.unit_tables[static_cast<std::size_t>(models::UnitKind::intersection)];
  CHECK(tables.arithmetic == "microprogrammed");
  CHECK(tables.program == "mc68020");
  CHECK(machine.tables.arithmetic == "motorola_ffp");
  CHECK(own->operations[static_cast<std::size_t>(firmware::Operation::add)].clocks == 7);
  CHECK(own->operations[static_cast<std::size_t>(firmware::Operation::multiply)].clocks == 5);
  CHECK(own->operations[static_cast<std::size_t>(firmware::Operation::leaf)].reads > 0);
  for (const CostSource& source : tables.sources) {
    CHECK_FALSE(source.text.empty());
  }
  const std::string written = write_yaml(write_machine(machine));
  CHECK(write_yaml(write_machine(read_machine(write_machine(machine)))) == written);
  const std::string other =
      configuration(load_text(configuration(description), {"units.intersection.arithmetic.add."
                                                           "clocks=8"}));
  CHECK(other != configuration(description));
  CHECK(configuration(load_text(other, {"units.intersection.arithmetic.add.clocks=7"})) ==
        configuration(description));
}

TEST_CASE("cost tables that a unit cannot have are refused with their place") {
  const auto refused = [](const std::string& tables) {
    return error_of(with_machine("{name: one, units: {intersection: {" + tables + "}}}"));
  };
  CHECK_THAT(
      refused("arithmetic: microprogrammed"),
      StartsWith("scene.yaml:4:") && ContainsSubstring("arithmetic is allowed with program"));
  CHECK_THAT(
      refused("program: microprogrammed"),
      StartsWith("scene.yaml:4:") && ContainsSubstring("program is allowed with arithmetic"));
  CHECK_THAT(refused("program: mc68000, arithmetic: microprogramed"),
             StartsWith("scene.yaml:4:") && ContainsSubstring("did you mean `microprogrammed`?"));
  CHECK_THAT(refused("program: mc68000, arithmetic: {name: mine}"),
             StartsWith("scene.yaml:4:") && ContainsSubstring("is missing"));
  CHECK_THAT(refused("program: mc68000, arithmetic: ''"), StartsWith("scene.yaml:4:"));
}

TEST_CASE("parameters of units are listed with their defaults where there are some") {
  const Description description =
      load_text(with_machine("{name: one, units: {intersection: {queue: 7}}}"));
  bool is_listed = false;
  for (const ParameterRow& row : list_parameters(description.machine)) {
    if (row.path == "units.intersection.queue") {
      is_listed = true;
      CHECK(row.value == "7");
      CHECK(row.default_value == "4");
    }
  }
  CHECK(is_listed);
}

}  // namespace maquette::sim
