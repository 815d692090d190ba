#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <glm/trigonometric.hpp>

#include "sim/database/frame_synthesis.hpp"
#include "sim/primitives/generatrix_curve.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/scene/description_loader.hpp"
#include "tools/benchmark/child_process.hpp"
#include "tools/benchmark/rows.hpp"

/// The picture of a vase against POV-Ray's of the same one: a lathe of the same Bezier sections.
namespace maquette::benchmark {

namespace {

constexpr const char* k_povray = "/usr/bin/povray";
/// In turn; the least of each counts, which a busy host disturbs least.
constexpr int k_repetitions = 9;

/// 0.2 s where POV-Ray 3.7 needs 0.9 s.
constexpr double k_ratio_bound = 0.2 / 0.9;

std::string vector_text(const sim::Vector3& v) {
  return fmt::format("<{:.9g}, {:.9g}, {:.9g}>", v.x, v.y, v.z);
}

std::string finish_text(const sim::Scene& scene, const std::string& surface) {
  const auto found =
      std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                   [&surface](const sim::Surface& each) { return each.name == surface; });
  return fmt::format("pigment {{ rgb {} }} finish {{ ambient {:.9g} diffuse 1 }}",
                     vector_text(found->diffuse), scene.ambient.x);
}

/// The discs of an open generatrix, which a lathe does not have.
std::string disc_text(const glm::dvec2& end, const std::string& finish) {
  return fmt::format("disc {{ <0, 0, {:.9g}>, z, {:.9g} {} }}\n", end.y, end.x, finish);
}

std::string vase_text(const sim::Scene& scene) {
  const sim::Object& vase = scene.object.children.front();
  const auto curve = sim::generatrix_curve(*sim::shape_of<sim::RevolutionShape>(*vase.primitive));
  const std::string finish = finish_text(scene, vase.surface);
  std::string points;
  for (std::size_t section = 0; section < curve.sections(); ++section) {
    for (std::size_t i = 3 * section; i <= 3 * section + 3; ++i) {
      points += fmt::format(", <{:.9g}, {:.9g}>", curve.points[i].x, curve.points[i].y);
    }
  }
  // POV-Ray turns about y.
  return fmt::format("lathe {{ bezier_spline {}{} {} rotate 90 * x }}\n", 4 * curve.sections(),
                     points, finish) +
         disc_text(curve.points.front(), finish) + disc_text(curve.points.back(), finish);
}

/// The scene of vase.yaml in POV-Ray's language.
std::string povray_text(const sim::Scene& scene, int width, int height) {
  const sim::View& view = scene.view;
  const double screen_height = 2 * std::tan(glm::radians(*view.field_of_view_deg) / 2);
  return fmt::format(
             "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n"
             "camera {{ location {} direction z right {:.9g} * x up {:.9g} * y sky z look_at {} "
             "}}\nlight_source {{ {}, rgb {} }}\nbackground {{ rgb {} }}\n",
             vector_text(view.eye), screen_height * width / height, screen_height,
             vector_text(view.target), vector_text(scene.lights.front().position),
             vector_text(scene.lights.front().intensity), vector_text(scene.background)) +
         vase_text(scene) +
         fmt::format("plane {{ z, 0 {} }}\n", finish_text(scene, scene.object.children[1].surface));
}

/// Processor time of the plain firmware: packing, preprocessing, synthesis.
double plain_s(const sim::Description& description) {
  const std::clock_t start = std::clock();
  const sim::PreparedScene<float> scene(
      sim::packed_scene<float>(description.scene, sim::picture_format_of(description.machine)));
  const sim::SynthesizedFrame frame = synthesized_frame(scene);
  const std::clock_t end = std::clock();
  return frame.rays > 0 ? static_cast<double>(end - start) / CLOCKS_PER_SEC : 0;
}

}  // namespace

std::vector<Row> measure_vase(const Paths& paths) {
  sim::DescriptionSources sources;
  sources.scene_file = paths.vase;
  sources.data_directory = paths.models;
  const sim::Description description = sim::load_description(sources);
  const auto& memory = description.machine.parameters.frame_memory;
  sim::write_files(paths.scratch,
                   {{"vase.pov", povray_text(description.scene, memory.width, memory.height)}});
  const bool has_povray = std::filesystem::exists(k_povray);
  const std::vector<std::string> command{
      "/bin/sh", "-c",
      fmt::format("exec {} +I{}/vase.pov +W{} +H{} -D -F -A +WT1 2>/dev/null", k_povray,
                  paths.scratch, memory.width, memory.height)};
  double plain = plain_s(description);
  double povray = has_povray ? run_process(command).user_time_s : 0;
  for (int i = 1; i < k_repetitions; ++i) {
    plain = std::min(plain, plain_s(description));
    if (has_povray) {
      povray = std::min(povray, run_process(command).user_time_s);
    }
  }
  std::vector<Row> rows{{"vase_frame", plain, "s", std::nullopt,
                         "a vase of 8 sections on a floor, with shadow, plain firmware"}};
  if (has_povray) {
    rows.push_back({"vase_povray", povray, "s", std::nullopt,
                    "user time of POV-Ray for the same picture, one thread"});
    rows.push_back({"vase_over_povray", plain / povray, "1", k_ratio_bound,
                    "processor time of the one over the other"});
  }
  return rows;
}

}  // namespace maquette::benchmark
