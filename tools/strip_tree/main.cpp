#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "firmware/polynomials/strip_tree.hpp"
#include "firmware/primitives/generatrix_conversion.hpp"
#include "models/board/work_cost.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/yaml/description_error.hpp"

/// What a strip tree of each generatrix of a scene would take to make anew in a frame, against the
/// sections of the paper's algorithm (section IV.1).
namespace maquette::strips {
namespace {

using firmware::Counted;

/// A generatrix in scene units, and how large a pixel is where it stands.
struct Curve {
  int sections;
  bool is_open;
  std::vector<Counted> points;
  double pixel;
};

/// Near is the point of its extent that is nearest to the eye.
std::vector<Curve> curves_of(const firmware::Frame<double>& frame) {
  std::vector<Curve> curves;
  const firmware::Database<double>& database = frame.database;
  for (firmware::NodeIndex i = 0; i < database.leaf_count; ++i) {
    const firmware::Leaf<double>& leaf = database.leaves[i];
    if (leaf.kind != firmware::kind_of<firmware::revolution::Kind>) {
      continue;
    }
    const auto generatrix =
        firmware::revolution::generatrix(database.parameters + leaf.first_parameter);
    const firmware::Affine<double>& to_screen = frame.prepared.leaves[i].to_screen;
    const double depth = database.needs.parallel_view ? 1 : frame.prepared.extents[i].box.low.z;
    Curve curve{generatrix.sections, generatrix.is_open, {}, database.observer.step * depth};
    for (int k = 0; k <= 3 * generatrix.sections; ++k) {
      const double* const point = generatrix.points + k * firmware::k_point_reals;
      curve.points.emplace_back(static_cast<float>(point[0] * glm::length(to_screen[0])));
      curve.points.emplace_back(static_cast<float>(point[1] * glm::length(to_screen[2])));
    }
    curves.push_back(curve);
  }
  return curves;
}

double milliseconds(const models::WorkCost& cost) {
  return static_cast<double>(cost.duration(firmware::counted_work()).count()) / 1e9;
}

/// What boards convert as many control points as the generatrix has to: Bezier points, turned the
/// right way, and the extents of their tree. Which values they have matters little: those of the
/// joints serve.
double sections_ms(const Curve& curve, const models::WorkCost& cost) {
  const int control_points = curve.sections + (curve.is_open ? 3 : 0);
  std::vector<Counted> given = {static_cast<float>(curve.sections), curve.is_open ? 1.0F : 0.0F,
                                1.0F, 1.0F};
  for (int i = 0; i < control_points; ++i) {
    const auto at =
        static_cast<std::size_t>(std::min(i, curve.sections) * firmware::k_section_stride);
    given.insert(given.end(), {curve.points[at], curve.points[at + 1]});
  }
  std::vector<Counted> parameters(
      static_cast<std::size_t>(firmware::revolution::parameter_count(curve.sections)));
  firmware::reset_counted_work();
  firmware::revolution::convert(given.data(), parameters.data());
  return milliseconds(cost);
}

void print(const std::string& name, const Curve& curve, double pixels,
           const models::WorkCost& cost) {
  std::size_t strips = 0;
  auto keep = [&strips](const firmware::strip_tree::Strip<Counted>& /*strip*/, int /*level*/) {
    ++strips;
  };
  firmware::reset_counted_work();
  const int levels =
      1 + firmware::strip_tree::build(curve.points.data(), curve.sections,
                                      Counted(static_cast<float>(pixels * curve.pixel)), keep);
  const double tree_ms = milliseconds(cost);
  const double own_ms = sections_ms(curve, cost);
  constexpr std::size_t k_real_bytes = 4;
  const auto section_bytes =
      k_real_bytes *
      static_cast<std::size_t>(firmware::revolution::parameter_count(curve.sections));
  fmt::print("{:<14}{:>9}{:>9.4g}{:>8}{:>8}{:>9}{:>9}{:>11.2f}{:>11.2f}{:>8.1f}\n", name,
             curve.sections, pixels, levels, strips,
             strips * firmware::strip_tree::k_strip_reals * k_real_bytes, section_bytes, tree_ms,
             own_ms, tree_ms / own_ms);
}

void print_scene(const std::string& data_directory, const std::string& scene) {
  const sim::Description description =
      sim::load_description({scene, std::string{"ccett-1984"}, {}, data_directory});
  const models::WorkCost cost(description.machine.parameters.board);
  const sim::PreparedScene<double> prepared(
      sim::packed_scene<double>(description.scene, sim::picture_format_of(description.machine)));
  for (const Curve& curve : curves_of(prepared.frame())) {
    for (const double pixels : {4.0, 1.0, 0.25, 0.0625}) {
      print(description.scene.name, curve, pixels, cost);
    }
  }
}

}  // namespace
}  // namespace maquette::strips

/// SystemC's library, in which the models are, wants it.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }

int main(int count, char** arguments) {
  if (count < 3) {
    std::cerr << "usage: strip_tree DIRECTORY SCENE...\nDIRECTORY holds models/ and the scenes.\n";
    return 2;
  }
  try {
    fmt::print("{:<14}{:>9}{:>9}{:>8}{:>8}{:>9}{:>9}{:>11}{:>11}{:>8}\n", "scene", "sections",
               "pixels", "levels", "strips", "bytes", "sections", "strips ms", "sections", "ratio");
    for (int i = 2; i < count; ++i) {
      maquette::strips::print_scene(arguments[1], arguments[i]);
    }
  } catch (const maquette::sim::DescriptionError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
