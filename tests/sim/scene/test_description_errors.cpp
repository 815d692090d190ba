#include <string>
#include <vector>

#include "firmware/facets/facet_table.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

/// A scene in which one piece is replaced; the pieces stand in known lines.
struct Pieces {
  std::string view = "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}";
  std::string lights = "lights: {key: {position: [1, 2, 3]}}";
  std::string rest = "shadows: true";
  std::string red = "  red: {diffuse: 0.5}";
  std::string object = "object: {sphere: {radius: 1}, surface: red}";
  std::string machine = "machine: ccett-1984";

  [[nodiscard]] std::string text() const {
    return view + "\n" + lights + "\n" + rest + "\nsurfaces:\n" + red + "\n" + object + "\n" +
           machine + "\n";
  }
};

std::string with_view(const std::string& view) {
  Pieces pieces;
  pieces.view = view;
  return error_of(pieces.text());
}
std::string with_lights(const std::string& lights) {
  Pieces pieces;
  pieces.lights = lights;
  return error_of(pieces.text());
}
std::string with_rest(const std::string& rest) {
  Pieces pieces;
  pieces.rest = rest;
  return error_of(pieces.text());
}
std::string with_surface(const std::string& red) {
  Pieces pieces;
  pieces.red = red;
  return error_of(pieces.text());
}
std::string with_object(const std::string& object) {
  Pieces pieces;
  pieces.object = object;
  return error_of(pieces.text());
}
std::string with_machine(const std::string& machine) {
  Pieces pieces;
  pieces.machine = machine;
  return error_of(pieces.text());
}
std::string with_override(const std::string& text) { return error_of(Pieces{}.text(), {text}); }

/// Whether a message starts with a position and says what is expected.
void check_error(const std::string& message, const std::string& start,
                 const std::string& expected) {
  INFO(message);
  CHECK(message.rfind(start, 0) == 0);
  CHECK(message.find(expected) != std::string::npos);
}

}  // namespace

TEST_CASE("the scene that the errors are made from is right") {
  CHECK(error_of(Pieces{}.text()).empty());
  CHECK(error_of(k_rich_scene).empty());
}

TEST_CASE("broken YAML is reported where it breaks") {
  check_error(with_rest("shadows: [1, 2"), "scene.yaml:4:9: ", "end of sequence flow");
  check_error(with_rest("shadows: \"abc"), "scene.yaml:3:10: ", "true, false");
  check_error(with_rest("shadows: *nothing"), "scene.yaml:3:", "");
  check_error(with_rest("shadows: !!bool true"), "scene.yaml:3:10: ", "tags are not used");
  check_error(with_rest("? [1, 2]\n: 3"), "scene.yaml:3:3: ", "a key must be a text");
  check_error(with_rest("shadows: true\n---\nname: second"), "scene.yaml:", "second document");
  check_error(error_of(""), "scene.yaml:1:1: ", "nothing is written");
  check_error(with_rest("a: &a [1, *a]"), "scene.yaml:3:11: ", "inside of what it refers to");
}

TEST_CASE("a time of the paper has its value and its source, or is not there") {
  check_error(with_rest("paper_time: {value: 7 min}"),
              "scene.yaml:3:13: ", "paper_time: `source` is missing");
  check_error(with_rest("paper_time: {source: there}"),
              "scene.yaml:3:13: ", "paper_time: `value` is missing");
  check_error(with_rest("paper_time: {value: 7, source: there}"),
              "scene.yaml:3:21: ", "`7` has no unit; allowed: ps, ns, us, ms, s, min");
  check_error(with_rest("paper_time: {value: 0 s, source: there}"),
              "scene.yaml:3:21: ", "allowed: 1 ps to 8640000 s");
  check_error(with_rest("paper_time: 7 min"), "scene.yaml:3:13: ", "a mapping is allowed");
  CHECK(with_rest("paper_time: {value: 7 min, source: there}").empty());
}

TEST_CASE("double keys are reported with the line of the first") {
  check_error(with_rest("shadows: true\nname: a\nshadows: false"),
              "scene.yaml:5:1: ", "`shadows` is given twice; it stands already in line 3");
  check_error(with_surface("  red: {specular: 1, specular: 0}"),
              "scene.yaml:5:22: ", "`specular` is given twice");
}

TEST_CASE("unknown keys are reported with the allowed ones and the nearest") {
  check_error(with_rest("shadow: true"),
              "scene.yaml:3:1: scene: unknown key `shadow`; allowed: ", "did you mean `shadows`?");
  check_error(with_view("view: {eyes: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}"),
              "scene.yaml:1:8: view: unknown key `eyes`; allowed: eye, projection, screen, target, "
              "up, field_of_view, horizontal_field_of_view, height; did you mean `eye`?",
              "");
  check_error(with_surface("  red: {metal: {index: 1, extinction: 2}, index: 1}"),
              "scene.yaml:5:43: red: unknown key `index`", "metal");
  check_error(with_object("object: {sphere: {radus: 1}, surface: red}"),
              "scene.yaml:6:19: ", "did you mean `radius`?");
  check_error(with_object("object: {ball: {radius: 1}, surface: red}"),
              "scene.yaml:6:10: ", "half_space");
  check_error(with_object("object: {half_space: {z: 1}, surface: red}"),
              "scene.yaml:6:23: ", "none is allowed here");
}

TEST_CASE("missing values are reported") {
  check_error(with_view("name: no view"), "scene.yaml:1:1: scene: `view` is missing", "");
  check_error(with_view("view: {eye: [1, 2, 3], field_of_view: 35 deg}"),
              "scene.yaml:1:7: ", "view: `target` is missing");
  check_error(with_object("name: no object"), "scene.yaml:1:1: scene: `object` is missing", "");
  check_error(with_lights("lights: {key: {intensity: 1}}"),
              "scene.yaml:2:15: ", "key: `position` is missing");
  check_error(with_object("object: {cone: {radius: 1}, surface: red}"),
              "scene.yaml:6:16: ", "one of height, from with to is allowed and needed");
  check_error(with_object("object: {surface: red}"), "scene.yaml:6:9: ", "what it is is missing");
}

TEST_CASE("values of the wrong type, unit or range are reported with what is allowed") {
  check_error(with_view("view: {eye: [4, -6], target: [0, 0, 0], field_of_view: 35 deg}"),
              "scene.yaml:1:13: eye: a list of 2 stands here; a list of three numbers is allowed",
              "");
  check_error(with_view("view: {eye: [4, -6, .nan], target: [0, 0, 0], field_of_view: 35 deg}"),
              "scene.yaml:1:21: eye: `.nan` is not a number", "");
  check_error(with_view("view: {eye: [4, -6, 1e400], target: [0, 0, 0], field_of_view: 35 deg}"),
              "scene.yaml:1:21: eye: `1e400` is beyond", "");
  check_error(with_view("view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35}"),
              "scene.yaml:1:59: field_of_view: `35` has no unit; allowed: deg", "");
  check_error(
      with_view("view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 180 deg}"),
      "scene.yaml:1:59: field_of_view: `180 deg` is out of range; allowed: 0.001 deg to 179 deg",
      "");
  check_error(with_rest("shadows: yes"), "scene.yaml:3:10: shadows: `yes` is not known",
              "true, false");
  check_error(with_rest("shadows: [true]"), "scene.yaml:3:10: shadows: a list stands here", "");
  check_error(with_rest("shadows:"), "scene.yaml:3:1: shadows: nothing stands here", "");
  check_error(with_rest("ray_tree: 4"), "scene.yaml:3:11: ray_tree: `4` stands here; a mapping",
              "");
  check_error(with_rest("ray_tree: {depth: 1.5}"), "scene.yaml:3:19: depth: `1.5` is not a whole",
              "");
  check_error(with_surface("  red: {diffuse: [0.5, 1.01, 0]}"),
              "scene.yaml:5:24: diffuse: `1.01` is out of range; allowed: 0 to 1", "");
  check_error(with_surface("  red: {facets: gausian}"), "scene.yaml:5:17: facets: `gausian`",
              "did you mean `gaussian`?");
  for (const firmware::FacetDistribution& facets : firmware::k_facet_distributions.rows) {
    check_error(with_surface("  red: {facets: rough}"), "scene.yaml:5:17: facets: `rough`",
                facets.name);
  }
  check_error(with_object("object: {sphere: {radius: 0}, surface: red}"),
              "scene.yaml:6:27: radius: `0` is out of range; allowed: above 0, to ", "");
  check_error(with_lights("lights: {a.b: {position: [1, 2, 3]}}"),
              "scene.yaml:2:10: ", "`a.b` is no name");
}

TEST_CASE("more surfaces or lights than have numbers are refused with the figure") {
  const auto named = [](int count, const std::string& value) {
    std::string list;
    for (int i = 0; i < count; ++i) {
      list += "  n" + std::to_string(i) + ": " + value + "\n";
    }
    return list;
  };
  constexpr int k_most = 65000;
  check_error(with_lights("lights:\n" + named(k_most + 1, "{position: [1, 2, 3]}")),
              "scene.yaml:3:3: lights: ", "65001 are given; up to 65000 are allowed");
  check_error(with_surface(named(k_most, "{}") + "  red: {diffuse: 0.5}"),
              "scene.yaml:5:3: surfaces: ", "65001 are given; up to 65000 are allowed");
}

TEST_CASE("views that show nothing are refused") {
  check_error(with_view("view: {eye: [1, 2, 3], target: [1, 2, 3], field_of_view: 35 deg}"),
              "scene.yaml:1:32: target: ", "where the eye is");
  check_error(
      with_view("view: {eye: [0, 0, 9], target: [0, 0, 0], up: [0, 0, -2], field_of_view: 35 deg}"),
      "scene.yaml:1:47: up: ", "across");
  check_error(with_view("view: {eye: [0, 0, 9], target: [0, 0, 0], field_of_view: 35 deg}"),
              "scene.yaml:1:7: up: ", "across");
  check_error(
      with_view("view: {eye: [9, 0, 9], target: [0, 0, 0], up: [0, 0, 0], field_of_view: 35 deg}"),
      "scene.yaml:1:47: up: ", "across");
  check_error(with_view("view: {eye: [9, 0, 9], target: [0, 0, 0]}"),
              "scene.yaml:1:7: ", "one of field_of_view, horizontal_field_of_view, screen");
  check_error(with_view("view: {eye: [9, 0, 9], target: [0, 0, 0], field_of_view: 35 deg, screen: "
                        "{distance: 1, width: 1, height: 1}}"),
              "scene.yaml:1:74: ", "one of field_of_view, horizontal_field_of_view, screen");
}

TEST_CASE("screens that cannot be are refused") {
  const std::string size = "width: 2, height: 1, place: ";
  check_error(with_view("view: {eye: [0, 0, 5], screen: {" + size + "{translate: [0, 0, 6]}}}"),
              "scene.yaml:1:61: place: ", "not in front");
  check_error(with_view("view: {eye: [0, 0, 5], screen: {" + size +
                        "{matrix: [1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]}}}"),
              "scene.yaml:1:61: place: ", "perpendicular");
  check_error(with_view("view: {eye: [0, 0, 5], target: [0, 0, 0], screen: {" + size +
                        "{translate: [0, 0, 1]}}}"),
              "scene.yaml:1:24: ", "target");
  CHECK(with_view("view: {eye: [0, 0, 5], screen: {" + size + "{translate: [0, 0, 1]}}}").empty());
}

TEST_CASE("trees of rays that would not end are refused") {
  Pieces glass;
  glass.red = "  red: {specular: 1, transparent: true}";
  const auto with_tree = [&glass](const std::string& tree) {
    glass.rest = "ray_tree: " + tree;
    return error_of(glass.text());
  };
  check_error(with_tree("{depth: 64, minimum_weight: 0}"), "scene.yaml:3:", "minimum_weight");
  check_error(with_tree("{depth: 1000, minimum_weight: 1e-5}"), "scene.yaml:3:", "depth");
  CHECK(with_tree("{depth: 64, minimum_weight: 0.00002}").empty());
  CHECK(with_tree("{depth: 16, minimum_weight: 0}").empty());
  CHECK(with_rest("ray_tree: {depth: 1000, minimum_weight: 0}").empty());
  // A surface that no body has does not count, one that it gets from the object above does.
  glass.red += "\n  blue: {diffuse: 1}";
  glass.object =
      "object: {surface: red, union: [{sphere: {radius: 1}, surface: blue}, "
      "{box: {size: 1}, surface: blue}]}";
  CHECK(with_tree("{depth: 1000, minimum_weight: 0}").empty());
  glass.object =
      "object: {surface: red, union: [{sphere: {radius: 1}, surface: blue}, "
      "{union: [{box: {size: 1}}, {box: {size: 2}, surface: blue}]}]}";
  check_error(with_tree("{depth: 1000, minimum_weight: 0}"), "scene.yaml:3:", "depth");
}

TEST_CASE("surfaces that cannot be are refused") {
  check_error(with_surface("  red: {index: [1, 2, 3]}"), "scene.yaml:5:16: index: ", "same index");
  check_error(with_surface("  red: {transparent: true, specular: 0}"),
              "scene.yaml:5:38: specular: ", "above 0 to 1");
  CHECK(with_surface("  red: {transparent: true}").empty());
  check_error(with_surface("  red: {absorption: 1}"), "scene.yaml:5:21: ", "transparent: true");
  check_error(with_surface("  red: {metal: {index: 1, extinction: 1}, transparent: true}"),
              "scene.yaml:5:56: transparent: ", "opaque");
  check_error(with_surface("  red: {metal: {index: 0, extinction: 0}}"),
              "scene.yaml:5:16: metal: ", "both 0");
}

TEST_CASE("textures, lights and samples that cannot be are refused") {
  check_error(with_surface("  red: {texture: {size: 2}}"),
              "scene.yaml:5:18: texture: ", "one of pattern, picture");
  check_error(with_surface("  red: {texture: {pattern: dots}}"),
              "scene.yaml:5:28: pattern: ", "checker, bands, rings");
  check_error(with_surface("  red: {specular: 1, texture: {pattern: bands}}"),
              "scene.yaml:5:31: texture: ", "less is allowed");
  check_error(with_surface("  red: {texture: {pattern: bands, repeat_u: 2}}"),
              "scene.yaml:5:35: ", "repeat_u");
  check_error(with_lights("lights: {key: {position: [1, 2, 3], spot: {target: [1, 2, 3]}}}"),
              "scene.yaml:2:52: target: ", "no direction");
  check_error(with_lights("lights: {key: {position: [1, 2, 3], falloff: 0}}"),
              "scene.yaml:2:46: falloff: ", "above 0");
  check_error(with_lights("lights: {key: {position: [1, 2, 3], place: {scale: 0}}}"),
              "scene.yaml:2:52: scale: ", "flattens");
  check_error(with_rest("samples: {per_side: 2, contrast: 0.1}"),
              "scene.yaml:3:34: contrast: ", "larger per_side");
  check_error(with_rest("samples: {per_side: 17}"), "scene.yaml:3:21: per_side: ", "1 to 16");
  CHECK(with_rest("samples: {per_side: 3, contrast: 0.1}").empty());
}

TEST_CASE("objects that cannot be are refused") {
  check_error(with_object("object: {sphere: {radius: 1}}"), "scene.yaml:6:9: ", "has a surface");
  check_error(
      with_object("object: {sphere: {radius: 1}, surface: rad}"),
      "scene.yaml:6:40: surface: `rad` is not among the surfaces; allowed: red; did you mean "
      "`red`?",
      "");
  check_error(with_object("object: {union: [{sphere: {radius: 1}}], surface: red}"),
              "scene.yaml:6:17: union: ", "two or more");
  check_error(with_object("object: {union: {sphere: {radius: 1}}, surface: red}"),
              "scene.yaml:6:17: union: ", "two or more");
  check_error(with_object("object: {sphere: {radius: 1}, box: {size: 1}, surface: red}"),
              "scene.yaml:6:31: object: it is a sphere already", "");
  check_error(with_object("object: {sphere: {}, surface: red}"),
              "scene.yaml:6:18: ", "radius, radii");
  check_error(with_object("object: {sphere: {radius: 1, radii: [1, 2, 3]}, surface: red}"),
              "scene.yaml:6:37: ", "radius, radii");
}

TEST_CASE("placements that flatten are refused") {
  const auto place = [](const std::string& steps) {
    return with_object("object: {sphere: {radius: 1}, surface: red, place: " + steps + "}");
  };
  check_error(place("{scale: 0}"), "scene.yaml:6:60: scale: ", "flattens");
  check_error(place("[{scale: [1, 0, 1]}]"), "scene.yaml:6:61: scale: ", "flattens");
  const std::string slanted = "{matrix: [1, 1, 0, 0, 1, 1.00001, 0, 0, 0, 0, 1, 0]}";
  check_error(place("[" + slanted + ", " + slanted + ", " + slanted + "]"),
              "scene.yaml:6:52: place: ", "together");
  check_error(place("{matrix: [1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0]}"),
              "scene.yaml:6:61: matrix: it flattens", "");
  check_error(place("{matrix: [1, 0, 0]}"), "scene.yaml:6:61: matrix: ", "twelve numbers");
  check_error(place("{rotate: {axis: [0, 0, 0], angle: 3 deg}}"),
              "scene.yaml:6:68: axis: ", "no direction");
  check_error(place("{rotate: {axis: [0, 0, 1]}}"), "scene.yaml:6:61: rotate: `angle` is missing",
              "");
  check_error(place("{turn: 3}"), "scene.yaml:6:53: place: unknown key `turn`", "translate");
  check_error(place("{scale: 2, translate: [0, 0, 1]}"),
              "scene.yaml:6:52: place: each step is one of", "");
  check_error(place("[{scale: 1e9}, {scale: 1e9}, {scale: 1e9}, {scale: 1e9}]"),
              "scene.yaml:6:52: place: ", "blow it up");
  std::string nested = "{sphere: {radius: 1}, place: {scale: 1e9}}";
  for (int i = 0; i < 3; ++i) {
    nested = "{union: [{half_space: {}}, " + nested + "], place: {scale: 1e9}}";
  }
  check_error(with_object("object: {surface: red, union: [{half_space: {}}, " + nested + "]}"),
              "scene.yaml:6:", "with those of the objects above it");
}

TEST_CASE("a scene's name is that of a file, or none") {
  check_error(with_rest("name: ../x"), "scene.yaml:3:7: name: ", "no name of a file");
  CHECK(with_rest("name: photo 4").empty());
  CHECK(load_text(Pieces{}.text()).scene.name.empty());
}

TEST_CASE("aliases stand for what they refer to") {
  Pieces pieces;
  pieces.rest = "ambient: &grey [0.5, 0.5, 0.5]\nbackground: *grey";
  CHECK(load_text(pieces.text()).scene.background == Color{0.5});
}

TEST_CASE("machines are checked as scenes are") {
  check_error(with_machine("machine: {name: a, procesors: 3}"),
              "scene.yaml:7:20: machine: ", "did you mean `processors`?");
  check_error(with_machine("machine: {processors: 3}"),
              "scene.yaml:7:10: machine: `name` is missing", "");
  check_error(with_machine("machine: {name: a, processors: 0}"),
              "scene.yaml:7:32: processors: ", "1 to 256");
  check_error(with_machine("machine: {name: a, board: {clock: 8}}"),
              "scene.yaml:7:35: clock: ", "Hz, kHz, MHz, GHz");
  check_error(with_machine("machine: {name: a, board: 3}"),
              "scene.yaml:7:27: board: ", "a mapping");
  check_error(with_machine("machine: [1]"), "scene.yaml:7:10: machine: ", "a mapping");
  check_error(with_machine("machine: ccett-1985"),
              "scene.yaml:7:10: ", "did you mean `ccett-1984`?");
  check_error(with_machine("machine: ./nothing.yaml"), "scene.yaml:7:10: ", "cannot read the file");
  check_error(with_machine("machine: {name: a, board: {arithmetic: motorola}}"),
              "scene.yaml:7:40: ", "ieee_single, m68010_ffp");
  check_error(with_machine("machine: {name: a, board: {arithmetic: {name: b, code: 1 B}}}"),
              "scene.yaml:7:40: arithmetic: `execution` is missing", "");
}

TEST_CASE("two masters in one place are refused") {
  check_error(with_override("boards.request_level=4"), "", "the host is at level 4, position 0");
  check_error(
      with_machine("machine: {name: a, boards: {places: [{level: 1, position: 0}, {level: 1, "
                   "position: 0}]}}"),
      "scene.yaml:7:37: boards.places: board 1 is at level 1, position 0, and so is board 0", "");
  check_error(
      with_machine("machine: {name: a, processors: 2, boards: {places: [{level: 1, position: "
                   "0}]}}"),
      "scene.yaml:7:52: boards.places: 1 places are listed for 2 processors", "");
  check_error(with_machine("machine: {name: a, boards: {request_level: 0, places: [{level: 1, "
                           "position: 0}]}}"),
              "scene.yaml:7:55: boards.places: ", "request_level is given too");
}

TEST_CASE("a machine whose addresses have more than the bus's 32 bits is refused") {
  const auto with = [](int processors, const std::string& ram) {
    return with_machine("machine: {name: a, processors: " + std::to_string(processors) +
                        ", board: {ram: " + ram + "}}");
  };
  check_error(with(256, "16 MiB"), "scene.yaml:7:50: board.ram: 256 boards ",
              "at most 8 MiB is allowed");
  CHECK(with(256, "8 MiB").empty());
  CHECK(with(253, "16 MiB").empty());
  CHECK_FALSE(with(254, "16 MiB").empty());
}

TEST_CASE("an interlace is of as many pixels as there are boards") {
  const auto with = [](const std::string& allotment, int processors) {
    return with_machine("machine: {name: a, processors: " + std::to_string(processors) +
                        ", allotment: {" + allotment + "}}");
  };
  check_error(with("order: interlaced, columns: 3", 4), "scene.yaml:7:75: allotment.columns: ",
              "4 boards cannot be shared out over 3; allowed: 1, 2, 4");
  check_error(with("order: interlaced, lines: 5", 6), "scene.yaml:7:73: allotment.lines: ",
              "6 boards cannot be shared out over 5; allowed: 1, 2, 3, 6");
  check_error(with("order: interlaced, columns: 2, lines: 2", 8),
              "scene.yaml:7:85: ", "2 columns and 2 lines are not the 8 boards; allowed: 4");
  check_error(with("order: interlaced, columns: 0", 4), "scene.yaml:7:75: ", "allowed: 1 to 256");
  check_error(with("columns: 2", 4),
              "scene.yaml:7:56: allotment.columns: ", "allowed with allotment.order=interlaced");
  check_error(with_override("allotment.lines=2"), "--set ", "allotment.order=interlaced");
  CHECK(with("order: interlaced", 7).empty());
  CHECK(with("order: interlaced, columns: 2, lines: 4", 8).empty());
}

TEST_CASE("boards keep pixels whose owner follows from their place") {
  const auto with = [](const std::string& machine) {
    return with_machine("machine: {name: a, frame_memory: {place: boards}, " + machine + "}");
  };
  const std::string place = "scene.yaml:7:42: frame_memory.place: ";
  check_error(with("processors: 4"), place, "allowed with allotment.order=interlaced");
  check_error(with("allotment: {order: interlaced, assignment: on_demand}"), place,
              "allowed with allotment.assignment=fixed");
  check_error(with("allotment: {order: interlaced}, board: {pixel_write: line}"), place,
              "allowed with board.pixel_write=pixel");
  check_error(with_machine("machine: {name: a, frame_memory: {place: boards, ports: 2}, allotment: "
                           "{order: interlaced}}"),
              place, "allowed with frame_memory.ports=1");
  CHECK(with("allotment: {order: interlaced}").empty());
}

TEST_CASE("depths are compared where there are some, a pixel at a time") {
  const auto with = [](const std::string& machine) {
    return with_machine("machine: {name: a, " + machine + "}");
  };
  const std::string deep = "red: 5 bits, green: 6 bits, blue: 5 bits, depth: 16 bits";
  const std::string compared = "frame_memory: {" + deep + ", depth_compare: true}";
  check_error(with("frame_memory: {depth_compare: true}"),
              "scene.yaml:7:50: frame_memory.depth_compare: ",
              "allowed with frame_memory.depth of 1 to 16 bits");
  check_error(with(compared), "scene.yaml:7:108: frame_memory.depth_compare: ",
              "allowed with one processor, with a bus.data_width of 32 bits, or with "
              "frame_memory.place=boards");
  check_error(with("frame_memory: {depth_compare: 1}"), "scene.yaml:7:50: ", "true, false");
  CHECK(with(compared + ", processors: 1").empty());
  CHECK(with(compared + ", bus: {data_width: 32 bits}").empty());
  CHECK(with("frame_memory: {" + deep +
             ", depth_compare: true, place: boards}, allotment: " + "{order: interlaced}")
            .empty());
  CHECK(with("frame_memory: {" + deep + ", depth_compare: false}").empty());
}

TEST_CASE("what no single value of a machine shows is checked") {
  check_error(with_override("video.pixel_clock=14.76 MHz"),
              "--set video.pixel_clock=14.76 MHz:1:19: ", "a multiple of 15625 Hz");
  check_error(with_override("frame_memory.width=800 pixels"), "--set ", "allows 789 pixels");
  check_error(with_override("frame_memory.height=1000 pixels"), "--set ",
              "first field ends in line");
  check_error(with_override("frame_memory.video_slot_time=2 us"), "--set ", "leaves nothing");
  check_error(with_override("frame_memory.video_slot=1 pixel"), "",
              "board0 to board3 would starve; at most 67795 ps");
  check_error(with_override("frame_memory.access_time=1 us"), "--set ",
              "board0 to board3 would starve; at most 684745 ps");
  check_error(with_override("board.access=0 clocks"), "--set ", "allowed: 1 clock");
  check_error(with_override("board.ram=12 KiB"), "--set ", "not even the stack");
  check_error(with_override("board.refresh=200 clocks"), "--set ", "leaves nothing");
  check_error(with_override("bus.timeout=200 ns"), "", "bus.timeout");
  check_error(with_machine("machine: {name: a, frame_memory: {ports: 2}, allotment: {assignment: "
                           "on_demand}}"),
              "scene.yaml:7:", "frame_memory.ports=1 only");
}

TEST_CASE("overrides are refused at their column") {
  check_error(with_override("processors"), "--set processors:1:11: ", "`=` is missing");
  check_error(with_override("=3"), "--set =3:1:1: ", "a name is missing");
  check_error(with_override("bus..clock=3"), "--set bus..clock=3:1:5: ", "a name is missing");
  check_error(with_override("bus.=3"), "--set bus.=3:1:5: ", "a name is missing");
  check_error(with_override("processors="), "--set processors=:1:12: ", "nothing");
  check_error(with_override("processors=x"), "--set processors=x:1:12: processors: `x`",
              "not a number");
  check_error(with_override("procesors=8"),
              "--set procesors=8:1:1: ", "did you mean `processors`?");
  check_error(with_override("bus.arbitraton=priority"),
              "--set bus.arbitraton=priority:1:5: bus: ", "did you mean `arbitration`?");
  check_error(with_override("bus.arbitration=round"),
              "--set bus.arbitration=round:1:17: ", "priority, round_robin");
  check_error(with_override("view.eye.3=1"), "--set view.eye.3=1:1:10: ", "from 0 to 2");
  check_error(with_override("view.eye.x=1"), "--set view.eye.x=1:1:10: ", "from 0 to 2");
  check_error(with_override("shadows.on=1"), "--set shadows.on=1:1:9: ", "a single value");
  check_error(with_override("view.eye=[1, 2"), "--set view.eye=[1, 2:1:", "");
  check_error(with_override("board.arithmetic=none"),
              "--set board.arithmetic=none:1:18: ", "motorola_ffp");
}

TEST_CASE("a picture is no wider or higher than the coordinates of the board's program reach") {
  for (const std::string side : {"width", "height"}) {
    check_error(with_override("frame_memory." + side + "=16385 pixels"), "--set ",
                "allowed: 1 pixel to 16384 pixels");
    check_error(with_override("allotment.tile_" + side + "=16385 pixels"), "--set ",
                "allowed: 1 pixel to 16384 pixels");
  }
}

}  // namespace maquette::sim
