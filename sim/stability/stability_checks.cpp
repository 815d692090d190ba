#include "sim/stability/stability_checks.hpp"

#include <algorithm>
#include <cmath>

#include "sim/stability/coincident_faces.hpp"
#include "sim/stability/extreme_scenes.hpp"
#include "sim/stability/extreme_solids.hpp"
#include "sim/stability/ray_parity.hpp"
#include "sim/stability/replaced_values.hpp"
#include "sim/stability/root_families.hpp"
#include "sim/stability/scene_scale.hpp"
#include "sim/stability/secondary_rays.hpp"
#include "sim/stability/thin_shells.hpp"

namespace maquette::sim {

namespace {

constexpr int k_picture_width = 256;
constexpr int k_ray_turns = 4000;
constexpr int k_tree_turns = 20000;
constexpr int k_body_turns = 4000;
constexpr int k_stretched_turns = 5000;
constexpr int k_generatrix_turns = 4000;
constexpr int k_replacement_turns = 4000;

}  // namespace

StabilityMaterial stability_material(const std::string& scenes_directory,
                                     const std::string& exact_roots_file) {
  StabilityMaterial material;
  material.exact_roots_file = exact_roots_file;
  material.scenes = shipped_scenes(scenes_directory);
  material.families = solid_families(material.scenes);
  return material;
}

const std::vector<std::string>& stability_groups() {
  static const std::vector<std::string> groups{"roots", "scale", "secondary_rays", "csg",
                                               "extreme"};
  return groups;
}

template <class Real>
std::vector<StabilityCheck> stability_checks(const StabilityMaterial& material, double share) {
  const auto turns = [share](int all) { return std::max(1, static_cast<int>(share * all)); };
  const int width = static_cast<int>(k_picture_width * std::sqrt(share));
  std::vector<StabilityCheck> checks;
  checks.push_back({"roots", [&material] { return root_rows<Real>(material.exact_roots_file); }});
  for (const ShippedScene& scene : material.scenes) {
    checks.push_back({"scale", [&scene, width] { return scale_rows<Real>(scene, width); }});
  }
  for (const SolidFamily& family : material.families) {
    checks.push_back({"secondary_rays", [&family, turns] {
                        return secondary_ray_rows<Real>(family, turns(k_ray_turns));
                      }});
  }
  checks.push_back({"csg", [&material, turns] {
                      return ray_parity_rows<Real>(material.families, turns(k_tree_turns));
                    }});
  for (const SolidFamily& family : material.families) {
    checks.push_back({"csg", [&family, turns] {
                        return coincident_solid_rows<Real>(family, turns(k_body_turns));
                      }});
  }
  checks.push_back({"csg", [turns] { return touching_box_rows<Real>(turns(k_body_turns)); }});
  checks.push_back({"csg", [&material, turns] {
                      return thin_shell_rows<Real>(material.families, turns(k_body_turns));
                    }});
  checks.push_back({"extreme", [&material] { return extreme_scene_rows<Real>(material.scenes); }});
  for (const SolidFamily& family : material.families) {
    checks.push_back({"extreme", [&family, turns] {
                        return stretched_solid_rows<Real>(family, turns(k_stretched_turns));
                      }});
  }
  checks.push_back(
      {"extreme", [turns] { return extreme_generatrix_rows<Real>(turns(k_generatrix_turns)); }});
  checks.push_back({"extreme", [&material, turns, share] {
                      return replaced_value_rows<Real>(material.scenes, turns(k_replacement_turns),
                                                       static_cast<int>(1 / share));
                    }});
  return checks;
}

template std::vector<StabilityCheck> stability_checks<float>(const StabilityMaterial& material,
                                                             double share);
template std::vector<StabilityCheck> stability_checks<double>(const StabilityMaterial& material,
                                                              double share);

}  // namespace maquette::sim
