#include "sim/report/result_directory.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "sim/report/replaceable.hpp"
#include "sim/report/unfinished.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_manifest = "manifest.json";

[[noreturn]] void fail(const fs::path& path, const char* what, const std::error_code& error) {
  throw DescriptionError(path.string() + ": " + what + ": " + error.message());
}

/// The path without a separator at its end, so that it has a name.
fs::path without_end(const fs::path& path) {
  return path.has_filename() || !path.has_parent_path() ? path : path.parent_path();
}

/// A link to nothing is there: no directory can take its name.
bool is_absent(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::not_found;
}

/// The directories of a path that are not there, the innermost first.
std::vector<fs::path> absent(fs::path path) {
  std::vector<fs::path> result;
  for (; !path.empty() && is_absent(path); path = path.parent_path()) {
    result.push_back(path);
  }
  return result;
}

/// The regular files below a directory, relative to it, in the order of their names.
std::vector<std::string> names_below(const fs::path& directory) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) {
      names.push_back(entry.path().lexically_relative(directory).generic_string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Whether a name of a manifest, which anybody may have edited, stays within its directory.
bool stays_within(const fs::path& name) {
  return !name.empty() && name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

/// What an earlier command left in a directory, as its manifest says.
std::vector<std::string> earlier_files(const fs::path& directory) {
  std::ifstream stream(directory / k_manifest);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  std::vector<std::string> names;
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) {
    return names;
  }
  for (const auto& name : json["files"]) {
    if (name.is_string() && stays_within(name.get<std::string>())) {
      names.push_back(name.get<std::string>());
    }
  }
  return names;
}

void remove_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::symlink_status(path, ignored).type() == fs::file_type::regular) {
    fs::remove(path, ignored);
  }
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    fail(to, "cannot be written", error);
  }
}

}  // namespace

ResultDirectory::ResultDirectory(fs::path directory)
    : directory_(without_end(std::move(directory))), is_new_(is_absent(directory_)) {
  const fs::path parent = is_new_ ? directory_.parent_path() : directory_;
  made_ = absent(parent);
  std::error_code error;
  if (!parent.empty()) {
    fs::create_directories(parent, error);
  }
  const std::string name = directory_.filename().string();
  workplace_ = parent / unfinished_name(is_new_ ? name : "results");
  if (!error) {
    clear_unfinished(directory_);
    clear_unfinished(directory_.has_parent_path() ? directory_.parent_path() : ".", name);
    fs::create_directory(workplace_, error);
  }
  if (error) {
    fail(directory_, "the run directory cannot be made", error);
  }
}

ResultDirectory::~ResultDirectory() {
  std::error_code ignored;
  fs::remove_all(workplace_, ignored);
  for (const fs::path& path : made_) {
    fs::remove(path, ignored);  // unless something is in it
  }
}

fs::path ResultDirectory::kept(const std::string& name) {
  kept_.push_back(name);
  return (is_new_ ? workplace_ : directory_) / name;
}

void ResultDirectory::publish(Manifest manifest) {
  for (const std::string& name : names_below(workplace_)) {
    if (std::find(kept_.begin(), kept_.end(), *fs::path(name).begin()) == kept_.end()) {
      manifest.files.push_back(name);
    }
  }
  write_files(workplace_, {{k_manifest, manifest_json(manifest)}});
  std::error_code error;
  if (is_new_) {
    fs::rename(workplace_, directory_, error);
  }
  // Another command may have made the directory in the meantime.
  if (!is_new_ || error) {
    publish_within();
  }
}

void ResultDirectory::publish_within() {
  std::vector<std::string> names = names_below(workplace_);
  const std::vector<std::string> earlier = earlier_files(directory_);
  for (const std::string& name : names) {
    replaceable(directory_ / name);
    if (const fs::path folder = (directory_ / name).parent_path(); folder != directory_) {
      create_run_directory(folder);
    }
  }
  remove_file(directory_ / k_manifest);
  for (const std::string& name : earlier) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      remove_file(directory_ / name);
    }
  }
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name != k_manifest; });
  for (const std::string& name : names) {
    move_file(workplace_ / name, directory_ / name);
  }
}

}  // namespace maquette::sim
