#include "sim/scene/scene_description.hpp"
#include "sim/scene/sequence.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/fuzz/descriptions.hpp"
#include "tests/fuzz/harness.hpp"

namespace maquette::fuzz {

namespace {

constexpr std::size_t k_most_seed_bytes = 4096;

/// The effective configuration of a scene reads back as the same scene.
void hold_configuration(const sim::Scene& scene) {
  const std::string written = sim::write_yaml(sim::write_scene(scene));
  try {
    const sim::Scene again = sim::read_scene(sim::parse_yaml(written, "config.yaml"));
    require(sim::write_yaml(sim::write_scene(again)) == written,
            "the effective configuration of a scene is another one when it is read again");
  } catch (const sim::DescriptionError& error) {
    throw BrokenLaw(std::string{"the effective configuration of a scene is refused: "} +
                    error.what());
  }
}

}  // namespace

void try_scene(const std::string& input) {
  try {
    const sim::YamlNode tree = read_tree(input);
    const sim::Scene scene = sim::read_scene(tree);
    hold_configuration(scene);
    static_cast<void>(sim::list_parameters(scene));
    if (scene.sequence) {
      const int last = scene.sequence->frames - 1;
      hold_configuration(sim::read_scene(sim::frame_of(tree, *scene.sequence, last)));
    }
  } catch (const sim::DescriptionError&) {
    return;
  }
}

std::vector<std::string> scene_seeds() { return texts_below("scenes", k_most_seed_bytes); }

}  // namespace maquette::fuzz
