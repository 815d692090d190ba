#include "sim/page/run_files.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>

#include "sim/page/provenance.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace fs = std::filesystem;

namespace {

/// Whether a page shows what this file of a run directory holds.
bool is_shown(std::string_view name) {
  constexpr std::array<std::string_view, 5> k_names{"stats.json", "config.yaml", "frame.png",
                                                    "manifest.json", "maps.exr"};
  constexpr std::string_view k_snapshot = "snapshot-";
  return std::find(k_names.begin(), k_names.end(), name) != k_names.end() ||
         name.substr(0, k_snapshot.size()) == k_snapshot;
}

}  // namespace

const NamedContent* RunFiles::find(std::string_view name) const {
  const auto place = std::find_if(files.begin(), files.end(),
                                  [name](const NamedContent& file) { return file.name == name; });
  return place == files.end() ? nullptr : &*place;
}

const std::string& RunFiles::content(std::string_view name) const {
  const NamedContent* file = find(name);
  if (file == nullptr) {
    throw DescriptionError((fs::path(directory) / name).string() +
                           ": is missing; allowed: a directory that `maquette run` has written");
  }
  return file->content;
}

RunFiles shown_files(const std::string& directory, const std::vector<NamedContent>& results,
                     const std::string& manifest) {
  RunFiles run{directory, {}};
  std::copy_if(results.begin(), results.end(), std::back_inserter(run.files),
               [](const NamedContent& file) { return is_shown(file.name); });
  // A manifest names files in the order of their names.
  std::sort(run.files.begin(), run.files.end(),
            [](const NamedContent& first, const NamedContent& second) {
              return first.name < second.name;
            });
  run.files.insert(run.files.begin(), {"manifest.json", manifest});
  return run;
}

RunFiles read_run_files(const fs::path& directory) {
  RunFiles run{directory.string(), {}};
  const fs::path manifest = directory / "manifest.json";
  std::error_code error;
  if (!fs::is_regular_file(manifest, error)) {
    throw DescriptionError(
        run.directory +
        ": holds no manifest.json; allowed: a directory of results, as `maquette "
        "run` writes it");
  }
  run.files.push_back({"manifest.json", read_file(manifest)});
  for (const std::string& name :
       parse_provenance(run.files.front().content, manifest.string()).files) {
    if (is_shown(name) && fs::path(name).filename() == name) {
      run.files.push_back({name, read_file(directory / name)});
    }
  }
  return run;
}

}  // namespace maquette::sim
