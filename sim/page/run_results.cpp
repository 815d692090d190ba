#include "sim/page/run_results.hpp"

#include "sim/picture/image_file.hpp"
#include "sim/report/statistics_json.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

Description description_of(const RunFiles& files, const std::string& data_directory) {
  const std::string name = (fs::path(files.directory) / "config.yaml").string();
  DescriptionSources sources;
  sources.scene_file = name;
  sources.data_directory = data_directory;
  sources.known = {{name, files.content("config.yaml")}};
  return load_description(sources);
}

Machine shipped_prototype(const std::string& data_directory) {
  DescriptionSources sources;
  sources.data_directory = data_directory;
  std::vector<InputFile> read;
  return load_machine(sources, read);
}

/// The last step of the directory's path that is a name; that of the scene where there is none.
std::string name_of(const RunFiles& files, const Scene& scene) {
  const fs::path path = fs::path(files.directory).lexically_normal();
  const std::string last = (path.has_filename() ? path : path.parent_path()).filename().string();
  return last.empty() || last == "." || last == ".." ? scene.name : last;
}

}  // namespace

RunResults run_results(const RunFiles& files, const std::string& data_directory) {
  const auto path_of = [&files](const char* name) {
    return (fs::path(files.directory) / name).string();
  };
  RunResults results;
  results.provenance = parse_provenance(files.content("manifest.json"), path_of("manifest.json"));
  results.statistics = parse_statistics(files.content("stats.json"), path_of("stats.json"));
  results.description = description_of(files, data_directory);
  results.prototype = shipped_prototype(data_directory);
  results.name = name_of(files, results.description.scene);
  results.frame_png = files.content("frame.png");
  decode_png(results.frame_png, path_of("frame.png"));
  for (const NamedContent& file : files.files) {
    if (file.name.rfind("snapshot-", 0) == 0) {
      results.snapshots.push_back(file);
    }
  }
  if (const NamedContent* maps = files.find("maps.exr")) {
    results.maps = decode_maps(maps->content, path_of("maps.exr"));
  }
  return results;
}

}  // namespace maquette::sim
