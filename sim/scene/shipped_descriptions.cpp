#include "sim/scene/shipped_descriptions.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

struct ShippedFolder {
  std::string_view kind;
  std::string_view folder;  ///< in the folder of data
};

constexpr std::array<ShippedFolder, 5> k_folders{{{"scenes", "scenes"},
                                                  {"studies", "scenes/studies"},
                                                  {"machines", "models/machines"},
                                                  {"arithmetic", "models/arithmetic"},
                                                  {"program", "models/program"}}};

fs::path folder_of(const std::string& data_directory, std::string_view kind) {
  const auto* const row = std::find_if(k_folders.begin(), k_folders.end(),
                                       [kind](const auto& folder) { return folder.kind == kind; });
  return fs::path{data_directory} / row->folder;
}

bool is_shipped_name(std::string_view name) {
  return name.find_first_of("/.") == std::string_view::npos;
}

[[noreturn]] void refuse(const std::string& message, const YamlPlace* place) {
  throw place == nullptr ? DescriptionError(message) : DescriptionError(place->position(), message);
}

}  // namespace

std::vector<ShippedDescription> shipped_descriptions(const std::string& data_directory,
                                                     std::string_view kind) {
  const fs::path folder = folder_of(data_directory, kind);
  // Studies stand among the scenes and are none.
  const fs::path other = kind == "scenes" ? folder_of(data_directory, "studies") : fs::path{};
  std::vector<ShippedDescription> descriptions;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator{folder, ignored}) {
    if (entry.path().extension() == ".yaml" && entry.path().parent_path() != other) {
      descriptions.push_back({entry.path().stem().string(), entry.path().string()});
    }
  }
  std::sort(descriptions.begin(), descriptions.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return descriptions;
}

std::string description_file(const std::string& name, const std::vector<std::string_view>& kinds,
                             const std::string& data_directory, const fs::path& base,
                             const YamlPlace* place) {
  const fs::path file = (base / name).lexically_normal();
  std::error_code ignored;
  // A pipe is as good as a file.
  if (fs::exists(file, ignored) && !fs::is_directory(file, ignored)) {
    return file.string();
  }
  if (!is_shipped_name(name)) {
    refuse("cannot read the file `" + file.string() + "`", place);
  }
  std::vector<std::string> names;
  std::string kinds_text;
  for (const std::string_view kind : kinds) {
    for (const ShippedDescription& description : shipped_descriptions(data_directory, kind)) {
      if (description.name == name) {
        return description.file;
      }
      names.push_back(description.name);
    }
    kinds_text.append(kinds_text.empty() ? "" : ", ").append(kind);
  }
  refuse("`" + name + "` is neither a file nor shipped (" + kinds_text + "); " +
             allowed_names(name, {names.begin(), names.end()}),
         place);
}

}  // namespace maquette::sim
