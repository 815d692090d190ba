#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/machine/machine.hpp"
#include "sim/scene/scene.hpp"
#include "sim/yaml/input_file.hpp"
#include "sim/yaml/override.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Where a description comes from.
struct DescriptionSources {
  std::string scene_file;
  std::optional<std::string> machine;  ///< goes before the scene's own; a file, or a shipped name
  std::vector<std::string> overrides;  ///< `path=value`, applied in this order
  std::string data_directory;          ///< holds models/ and scenes/, as they are shipped
  std::vector<InputFile> known{};      ///< files that were read before and are not read again
};

/// A checked description and the files that it was read from, in the order of reading.
struct Description {
  Scene scene;                ///< without the values of its sequence
  std::vector<Scene> frames;  ///< of its sequence; none without
  Machine machine;
  std::vector<InputFile> input_files;
};

/// Reads the scene, its machine and its cost tables. The machine is `sources.machine`, or what the
/// scene names or holds under `machine`, or the shipped ccett-1984; the cost tables are what the
/// machine names or holds under board.arithmetic and board.program, or the shipped motorola_ffp and
/// mc68000, and what it names or holds under the same keys of its units. Names of files are
/// relative to the file that names them; where there is none, it may be the name of a shipped one.
/// The first step of an override's path decides whether it goes to the scene or to the machine;
/// `machine.` may be written before it.
/// Throws DescriptionError.
[[nodiscard]] Description load_description(const DescriptionSources& sources);

/// What can stand as the name of a file and be put in its place.
enum class DescriptionPart { scene, machine, arithmetic, program };

/// Puts the file that `part` names, if it is a name, in its place, and with it what that file names
/// in turn; a scene's own machine stays in the scene. Remembers the files in `input_files`. Throws
/// DescriptionError.
void inline_files(YamlNode& part, DescriptionPart kind, const std::string& data_directory,
                  std::vector<InputFile>& input_files);

/// A description before it is checked.
struct DescriptionTrees {
  YamlNode scene;    ///< may hold its machine; nothing else names a file
  YamlNode machine;  ///< goes before the scene's own; null where there is none
};

/// Applies the changes to trees without names of files and checks the result: load_description for
/// many descriptions that differ in little. Throws DescriptionError.
[[nodiscard]] Description read_description(DescriptionTrees trees,
                                           const std::vector<Override>& changes,
                                           const std::string& data_directory);

/// The same without a scene; without `sources.machine` it is the shipped ccett-1984.
[[nodiscard]] Machine load_machine(const DescriptionSources& sources,
                                   std::vector<InputFile>& input_files);

/// Whether the file describes a machine rather than a scene: it has a board or processors, and
/// neither object nor view.
/// Throws DescriptionError when it is no YAML.
[[nodiscard]] bool describes_machine(const InputFile& file);

/// The scene with its machine and cost tables inline, as text: every value, and nothing of where it
/// came from, so that loading it gives the same description.
[[nodiscard]] std::string effective_configuration(const Scene& scene, const Machine& machine);

}  // namespace maquette::sim
