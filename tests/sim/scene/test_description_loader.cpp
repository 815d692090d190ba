#include "sim/scene/description_loader.hpp"

#include "models/bus/arbitration_policies.hpp"
#include "sim/machine/machine_description.hpp"
#include "sim/primitives/sphere.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

std::string configuration(const Description& description) {
  return effective_configuration(description.scene, description.machine);
}

void check_equal(const Object& left, const Object& right) {
  REQUIRE(left.primitive.has_value() == right.primitive.has_value());
  if (left.primitive) {
    const PrimitiveDescription& description = *left.primitive->description;
    CHECK(&description == right.primitive->description);
    CHECK(write_yaml(description.write(left.primitive->shape)) ==
          write_yaml(description.write(right.primitive->shape)));
  }
  CHECK(left.combination == right.combination);
  CHECK(left.name == right.name);
  CHECK(left.placement == right.placement);
  CHECK(left.surface == right.surface);
  REQUIRE(left.children.size() == right.children.size());
  for (std::size_t i = 0; i < left.children.size(); ++i) {
    check_equal(left.children[i], right.children[i]);
  }
}

}  // namespace

TEST_CASE("the effective configuration is a fixed point") {
  const Description first = load_text(k_rich_scene);
  const std::string text = configuration(first);
  const Description second = load_text(text);
  check_equal(first.scene.object, second.scene.object);
  CHECK(second.input_files.size() == 1);
  CHECK(first.input_files.size() == 4);
  CHECK(configuration(second) == text);
}

TEST_CASE("the effective configuration keeps what overrides changed, and places in a list") {
  const std::vector<std::string> overrides = {
      "processors=2",
      "boards={places: [{level: 3, position: 1}, {level: 2, position: 7}]}",
      "bus.arbitration=round_robin",
      "bus.data_width=32 bits",
      "board.clock=12.5MHz",
      "board.arithmetic=mc68881",
      "board.arithmetic.multiply.clocks=123.25",
      "object.union.0.sphere.radius=1.25",
      "lights.key.intensity=[1, 2, 3]",
      "shadows=false",
      "view.eye.0=5",
      "machine.name=\"what: if\"",
      "name=\"null\""};
  const Description first = load_text(k_rich_scene, overrides);
  CHECK(first.machine.parameters.boards.size() == 2);
  CHECK(first.machine.parameters.boards[1].level == 2);
  CHECK(first.machine.parameters.boards[1].position == 7);
  CHECK(first.machine.parameters.bus.arbitration == models::k_round_robin);
  CHECK(first.machine.parameters.bus.data_width_bits == 32);
  CHECK(first.machine.parameters.board.clock_hz == 12.5e6);
  CHECK(first.machine.tables.arithmetic == "mc68881");
  const auto multiply = static_cast<std::size_t>(firmware::Operation::multiply);
  CHECK(first.machine.parameters.board.arithmetic.operations[multiply].clocks == 123.25);
  CHECK(first.machine.parameters.board.arithmetic.operations[multiply].reads == 31);
  CHECK(shape_of<SphereShape>(*first.scene.object.children[0].primitive)->radii == Vector3{1.25});
  CHECK(first.scene.lights[0].intensity == Color{1, 2, 3});
  CHECK_FALSE(first.scene.shadows);
  CHECK(first.scene.view.eye == Vector3{5, -6, 3});
  CHECK(first.machine.name == "what: if");
  CHECK(first.scene.name == "null");
  const Description second = load_text(configuration(first));
  CHECK(configuration(second) == configuration(first));
  CHECK(second.machine.parameters.boards[0].level == 3);
  CHECK(second.machine.name == "what: if");
  CHECK(second.scene.name == "null");
}

TEST_CASE("overrides are applied in their order, and processors grow along the daisy chain") {
  const Description description = load_text(k_rich_scene, {"processors=3", "processors=8"});
  const auto& boards = description.machine.parameters.boards;
  REQUIRE(boards.size() == 8);
  for (int i = 0; i < 8; ++i) {
    CHECK(boards[static_cast<std::size_t>(i)].level == 0);
    CHECK(boards[static_cast<std::size_t>(i)].position == i);
  }
}

TEST_CASE("the shipped prototype says every figure and says the declared defaults") {
  const std::string file = (data_directory() / "models/machines" / "ccett-1984.yaml").string();
  std::vector<InputFile> input_files;
  const Machine machine = load_machine({{}, file, {}, data_directory().string()}, input_files);
  Machine standard = default_machine();
  standard.name = machine.name;
  standard.tables.arithmetic = machine.tables.arithmetic;
  standard.tables.program = machine.tables.program;
  standard.tables.sources = machine.tables.sources;
  standard.parameters.board.arithmetic = machine.parameters.board.arithmetic;
  for (const ParameterRow& row : list_parameters(machine)) {
    INFO(row.path);
    CHECK((row.required || row.value == row.default_value));
    CHECK_FALSE(row.sentence.empty());
  }
  const auto count_values = [](const YamlNode& node, const auto& count) -> std::size_t {
    std::size_t values = node.entries.empty() ? 1 : 0;
    for (const YamlEntry& entry : node.entries) {
      values += count(entry.value, count);
    }
    return values;
  };
  YamlNode written = write_machine(machine);
  *written.find("board")->find("arithmetic") = yaml_scalar("motorola_ffp");
  *written.find("board")->find("program") = yaml_scalar("mc68000");
  CHECK(count_values(load_yaml(file), count_values) == count_values(written, count_values));
  const std::string expected[] = {
      file, (data_directory() / "models/arithmetic/motorola_ffp.yaml").string(),
      (data_directory() / "models/program/mc68000.yaml").string()};
  REQUIRE(input_files.size() == std::size(expected));
  for (std::size_t i = 0; i < input_files.size(); ++i) {
    CHECK(input_files[i].path == expected[i]);
    CHECK(input_files[i].content == read_text(expected[i]));
  }
}

TEST_CASE("every shipped cost table loads, orders its costs sensibly and marks its sources") {
  for (const char* name : {"motorola_ffp", "ieee_single", "mc68881", "microprogrammed"}) {
    INFO(name);
    const Description description =
        load_text(k_rich_scene, {std::string{"board.arithmetic="} + name});
    const Machine& machine = description.machine;
    CHECK(machine.tables.arithmetic == name);
    for (std::size_t i = 0; i < firmware::k_operation_count; ++i) {
      INFO(firmware::k_operation_names[i]);
      const models::OperationCost& cost = machine.parameters.board.arithmetic.operations[i];
      CHECK((cost.clocks > 0 || i >= firmware::k_arithmetic_count));
      // A bus cycle of the 68000 takes four clocks.
      CHECK(4 * (cost.reads + cost.writes) <= cost.clocks + 1e-9);
      CHECK_FALSE(machine.tables.sources[i].text.empty());
    }
  }
}

TEST_CASE("files are found relative to the file that names them") {
  const tests::ScratchDirectory directory;
  const std::string table = read_text(data_directory() / "models/arithmetic/mc68881.yaml");
  write_file(directory, "tables/mine.yaml", table);
  const std::string machine =
      write_file(directory, "machines/big.yaml",
                 "name: big\nprocessors: 16\nboard: {arithmetic: ../tables/mine.yaml}\n");
  const std::string scene =
      write_file(directory, "scenes/one.yaml", k_rich_scene + "machine: ../machines/big.yaml\n");
  const std::string models = data_directory().string();
  const Description named = load_description({scene, {}, {}, models});
  CHECK(named.machine.parameters.boards.size() == 16);
  CHECK(named.machine.tables.arithmetic == "mc68881");
  CHECK(named.input_files.size() == 4);
  CHECK(load_description({scene, "ccett-1984", {}, models}).machine.parameters.boards.size() == 4);
  CHECK(load_description({scene, machine, {}, models}).machine.name == "big");
  CHECK(load_text(k_rich_scene + "machine: {name: bare}\n").machine.tables.arithmetic ==
        "motorola_ffp");
  CHECK(load_description({scene, machine, {"board.call_overhead.clocks=20"}, models})
            .machine.parameters.board.call_overhead.reads == 12);
  CHECK(describes_machine(read_input(machine)));
  CHECK_FALSE(describes_machine(read_input(scene)));
}

TEST_CASE("a hundred thousand objects load, and nesting as deep as is allowed") {
  std::string scene =
      "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
      "surfaces: {red: {}}\nobject:\n  surface: red\n  union:\n";
  for (int i = 0; i < 100'000; ++i) {
    scene +=
        "    - {sphere: {radius: 0.5}, place: {translate: [" + std::to_string(i) + ", 0, 1]}}\n";
  }
  const Description description = load_text(scene);
  CHECK(description.scene.object.children.size() == 100'000);
  CHECK(description.scene.object.children[99'999].placement[3].x == 99'999);
  std::string deep = "{sphere: {radius: 1}}";
  for (int i = 1; i < 200; ++i) {
    deep = "{union: [" + deep + ", {sphere: {radius: 1}}]}";
  }
  const std::string head =
      "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
      "surfaces: {red: {}}\nobject: {surface: red, union: [{half_space: {}}, ";
  CHECK(error_of(head + "{half_space: {}}]}\n").empty());
  const std::string with_surface =
      "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
      "surfaces: {red: {}}\nobject: {surface: red, " +
      deep.substr(1) + "\n";
  CHECK(error_of(with_surface).empty());
  const Description loaded = load_text(with_surface);
  CHECK(configuration(load_text(configuration(loaded))) == configuration(loaded));
  CHECK(error_of(head + deep + "]}\n").find("nested deeper than 200 levels") != std::string::npos);
}

}  // namespace maquette::sim
