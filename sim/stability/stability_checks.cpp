#include "sim/stability/stability_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "sim/stability/coincident_faces.hpp"
#include "sim/stability/counted_transfers.hpp"
#include "sim/stability/crowded_machines.hpp"
#include "sim/stability/exact_light.hpp"
#include "sim/stability/extreme_scenes.hpp"
#include "sim/stability/extreme_solids.hpp"
#include "sim/stability/ray_parity.hpp"
#include "sim/stability/replaced_values.hpp"
#include "sim/stability/root_families.hpp"
#include "sim/stability/scene_scale.hpp"
#include "sim/stability/secondary_rays.hpp"
#include "sim/stability/stiff_machines.hpp"
#include "sim/stability/thin_shells.hpp"

namespace maquette::sim {

namespace {

constexpr int k_picture_width = 256;
constexpr int k_ray_trials = 4000;
constexpr int k_tree_trials = 20000;
constexpr int k_body_trials = 4000;
constexpr int k_light_pictures = 300;
constexpr int k_stretched_trials = 5000;
constexpr int k_generatrix_trials = 4000;
constexpr int k_replacement_trials = 4000;
constexpr double k_transfers = 1e9;
constexpr std::int64_t k_least_transfers = 1'000'000;

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
  static const std::vector<std::string> groups{"machines", "roots", "scale",  "secondary_rays",
                                               "csg",      "light", "extreme"};
  return groups;
}

namespace {

/// Of machines, in which no number type shows. First, since processes are best forked before there
/// are threads.
void append_machine_checks(double share, std::vector<StabilityCheck>& checks) {
  for (const auto& cases :
       {stiff_machines, endless_machines, crowded_machines, watched_machines, starving_machines}) {
    checks.push_back({"machines", [cases] { return machine_case_rows(cases()); }});
  }
  const auto transfers =
      std::max<std::int64_t>(k_least_transfers, static_cast<std::int64_t>(share * k_transfers));
  checks.push_back({"machines", [transfers] { return counted_transfer_rows(transfers); }});
}

}  // namespace

template <class Real>
std::vector<StabilityCheck> stability_checks(const StabilityMaterial& material, double share) {
  const auto trials = [share](int all) { return std::max(1, static_cast<int>(share * all)); };
  const int width = static_cast<int>(k_picture_width * std::sqrt(share));
  std::vector<StabilityCheck> checks;
  if (std::is_same_v<Real, float>) {
    append_machine_checks(share, checks);
  }
  checks.push_back({"roots", [&material] { return root_rows<Real>(material.exact_roots_file); }});
  for (const ShippedScene& scene : material.scenes) {
    checks.push_back({"scale", [&scene, width] { return scale_rows<Real>(scene, width); }});
  }
  for (const SolidFamily& family : material.families) {
    checks.push_back({"secondary_rays", [&family, trials] {
                        return secondary_ray_rows<Real>(family, trials(k_ray_trials));
                      }});
  }
  checks.push_back({"csg", [&material, trials] {
                      return ray_parity_rows<Real>(material.families, trials(k_tree_trials));
                    }});
  for (const SolidFamily& family : material.families) {
    checks.push_back({"csg", [&family, trials] {
                        return coincident_solid_rows<Real>(family, trials(k_body_trials));
                      }});
  }
  checks.push_back({"csg", [trials] { return touching_box_rows<Real>(trials(k_body_trials)); }});
  checks.push_back({"csg", [&material, trials] {
                      return thin_shell_rows<Real>(material.families, trials(k_body_trials));
                    }});
  if (std::is_same_v<Real, float>) {
    checks.push_back({"light", [&material, trials] {
                        return exact_light_rows(material.families, trials(k_light_pictures));
                      }});
  }
  checks.push_back({"extreme", [&material] { return extreme_scene_rows<Real>(material.scenes); }});
  for (const SolidFamily& family : material.families) {
    checks.push_back({"extreme", [&family, trials] {
                        return stretched_solid_rows<Real>(family, trials(k_stretched_trials));
                      }});
  }
  checks.push_back(
      {"extreme", [trials] { return extreme_generatrix_rows<Real>(trials(k_generatrix_trials)); }});
  checks.push_back({"extreme", [&material, trials, share] {
                      return replaced_value_rows<Real>(material.scenes,
                                                       trials(k_replacement_trials),
                                                       static_cast<int>(1 / share));
                    }});
  return checks;
}

template std::vector<StabilityCheck> stability_checks<float>(const StabilityMaterial& material,
                                                             double share);
template std::vector<StabilityCheck> stability_checks<double>(const StabilityMaterial& material,
                                                              double share);

}  // namespace maquette::sim
