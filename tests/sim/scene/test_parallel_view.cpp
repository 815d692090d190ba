#include <cmath>
#include <fstream>
#include <iterator>

#include "firmware/arithmetic/elementary.hpp"
#include "sim/database/frame_synthesis.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

/// What an orthographic view shows.
namespace maquette::sim {
namespace {

using Catch::Matchers::ContainsSubstring;

constexpr PictureFormat k_size{96, 72};

Scene shown_scene(const std::vector<std::string>& overrides = {}) {
  std::ifstream file(MAQUETTE_PROJECT_DIRECTORY "/scenes/effects/orthographic.yaml");
  return load_text({std::istreambuf_iterator<char>(file), {}}, overrides).scene;
}

template <class Real>
std::vector<std::uint32_t> picture_of(const Scene& scene) {
  return synthesized_frame(PreparedScene<Real>(packed_scene<Real>(scene, k_size))).picture.pixels;
}

int differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    count += a[i] == b[i] ? 0 : 1;
  }
  return count;
}

TEST_CASE("A box on a plane is drawn as its parallel projection has it") {
  // Seen at 45 degrees: up in the picture is (0, 1, 1) / sqrt 2. The light is behind the eye.
  const Scene scene = load_text(R"(
view: {eye: [0, -10, 10], target: [0, 0, 0], projection: orthographic, height: 6}
lights: {sky: {position: [0, 0, 1e6], intensity: [3, 3, 3]}}
ambient: [0.2, 0.2, 0.2]
background: [0, 0, 1]
surfaces: {body: {diffuse: 1}}
object: {box: {size: [3, 1, 1]}, surface: body, place: {translate: [0.5, 0, 0.5]}}
)")
                          .scene;
  const std::vector<std::uint32_t> pixels = picture_of<double>(scene);
  const std::uint32_t sky = 0x0000FF;
  const std::uint32_t front = pixels[std::size_t{36} * 96 + 48];
  const std::uint32_t top = pixels[std::size_t{27} * 96 + 48];
  REQUIRE(front != sky);
  REQUIRE(top != sky);
  REQUIRE(top != front);
  const double step = 6.0 / k_size.height;
  const double scale = std::sqrt(0.5);
  for (int row = 0; row < k_size.height; ++row) {
    for (int column = 0; column < k_size.width; ++column) {
      const double x = (column - 47.5) * step;
      const double y = (35.5 - row) * step;
      const bool across = x > -1 && x < 2;
      const std::uint32_t expected = across && y > -0.5 * scale && y < 0.5 * scale  ? front
                                     : across && y > 0.5 * scale && y < 1.5 * scale ? top
                                                                                    : sky;
      INFO(column << ", " << row);
      REQUIRE(pixels[static_cast<std::size_t>(row * k_size.width + column)] == expected);
    }
  }
}

TEST_CASE("A parallel view is the same from any place along its axis") {
  const std::vector<std::uint32_t> near = picture_of<double>(shown_scene());
  for (const double farther : {0.3, 5.0, 200.0}) {
    Scene scene = shown_scene();
    scene.view.eye += (scene.view.eye - scene.view.target) * farther;
    CHECK(differing(picture_of<double>(scene), near) == 0);
  }
}

TEST_CASE("A parallel view is the limit of one in perspective from far off") {
  const std::vector<std::uint32_t> parallel = picture_of<double>(shown_scene());
  int last = k_size.width * k_size.height;
  for (const double distance : {1e1, 1e3, 1e6}) {
    Scene scene = shown_scene();
    const Vector3 back = glm::normalize(scene.view.eye - scene.view.target);
    scene.view.eye = scene.view.target + back * distance;
    scene.view.projection.reset();
    scene.view.height.reset();
    scene.view.field_of_view_deg =
        2 * std::atan(6 / (2 * distance)) * (180 / firmware::elementary::k_pi);
    const int now = differing(picture_of<double>(scene), parallel);
    CHECK(now < last);
    last = now;
  }
  CHECK(last <= 2);
}

TEST_CASE("A screen is a window of a parallel view, whatever its distance") {
  const std::vector<std::uint32_t> by_height = picture_of<double>(shown_scene());
  for (const double distance : {0.5, 3.0, 40.0}) {
    Scene scene = shown_scene();
    scene.view.height.reset();
    scene.view.screen = Screen{distance, 8, 6, {}};
    CHECK(differing(picture_of<double>(scene), by_height) == 0);
  }
  // Placed with its sides along those of the picture, a unit to the right and two in front.
  Scene scene = load_text(R"(
view: {eye: [0, 0, 9], projection: orthographic, screen: {width: 4, height: 3, place: {translate: [1, 0, 7]}}}
surfaces: {body: {diffuse: 1, ambient: 1}}
ambient: [1, 1, 1]
object: {box: {size: [2, 2, 2]}, surface: body}
)")
                    .scene;
  const std::vector<std::uint32_t> pixels = picture_of<double>(scene);
  for (int column = 0; column < k_size.width; ++column) {
    const double x = 1 + (column - 47.5) * 4 / 96;
    CHECK((pixels[std::size_t{36} * 96 + static_cast<std::size_t>(column)] != 0) == (x < 1));
  }
}

TEST_CASE("Several rays a pixel, single precision and depth are of a parallel view, too") {
  const std::vector<std::uint32_t> exact = picture_of<double>(shown_scene());
  CHECK(differing(picture_of<float>(shown_scene()), exact) < 10);
  // A grid of rays is the mean of the pixels of a picture three times as fine.
  constexpr PictureFormat k_fine{3 * 96, 3 * 72};
  const std::vector<std::uint32_t> fine =
      synthesized_frame(PreparedScene<double>(packed_scene<double>(shown_scene(), k_fine)))
          .picture.pixels;
  const std::vector<std::uint32_t> sampled =
      picture_of<double>(shown_scene({"samples.per_side=3"}));
  for (int i = 0; i < k_size.width * k_size.height; ++i) {
    double mean = 0;
    for (int k = 0; k < 9; ++k) {
      const int row = 3 * (i / k_size.width) + k / 3;
      const int column = 3 * (i % k_size.width) + k % 3;
      mean += (fine[static_cast<std::size_t>(row * k_fine.width + column)] >> 8 & 0xFF) / 9.0;
    }
    REQUIRE(std::abs(mean - (sampled[static_cast<std::size_t>(i)] >> 8 & 0xFF)) <= 1.0);
  }
  const PreparedScene<double> deep(
      packed_scene<double>(shown_scene(), PictureFormat{96, 72, true}));
  SynthesisArea<double> area(deep.frame().database);
  const auto depth_at = [&](std::int16_t column, std::int16_t row) {
    return firmware::synthesize(deep.frame(), area.view(), column, row).depth;
  };
  // Nearer to the lower edge of the picture the floor is nearer.
  CHECK(depth_at(48, 70) < depth_at(48, 10));
}

TEST_CASE("What a view shows is said once, in the words of its projection") {
  const auto refusal = [](const std::string& view) {
    try {
      load_text("view: {eye: [0, -9, 0], target: [0, 0, 0], " + view +
                "}\nsurfaces: {a: {}}\nobject: {sphere: {radius: 1}, surface: a}\n");
    } catch (const DescriptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal("projection: orthographic, height: 3").empty());
  CHECK(refusal("projection: perspective, field_of_view: 30 deg").empty());
  for (const char* view : {"projection: orthographic",
                           "projection: orthographic, height: 3, "
                           "field_of_view: 30 deg",
                           "projection: orthographic, field_of_view: 30 deg"}) {
    CHECK_THAT(refusal(view), ContainsSubstring("of an orthographic view one of height, screen"));
  }
  CHECK_THAT(refusal("height: 3"), ContainsSubstring("allowed where projection is orthographic"));
  CHECK_THAT(refusal("projection: oblique, height: 3"), ContainsSubstring("orthographic"));
}

}  // namespace
}  // namespace maquette::sim
