#include "sim/report/run_directory.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "sim/report/replaceable.hpp"
#include "sim/report/unfinished.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* what, const std::string& reason) {
  throw DescriptionError(path.string() + ": " + what + ": " + reason);
}

fs::path unfinished_path(const fs::path& directory, const std::string& name) {
  return directory / unfinished_name(name);
}

void write_unfinished(const fs::path& path, const std::string& content) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) {
    fail(path, "cannot be written", std::strerror(errno));
  }
}

// Files written beside their names; those not published are removed, whatever happens.
class UnfinishedFiles {
 public:
  UnfinishedFiles(const fs::path& directory, const std::vector<NamedContent>& files)
      : directory_(directory), files_(files) {}
  UnfinishedFiles(const UnfinishedFiles&) = delete;
  UnfinishedFiles& operator=(const UnfinishedFiles&) = delete;
  UnfinishedFiles(UnfinishedFiles&&) = delete;
  UnfinishedFiles& operator=(UnfinishedFiles&&) = delete;
  ~UnfinishedFiles() {
    for (const auto& file : files_) {
      std::error_code ignored;
      fs::remove(unfinished_path(directory_, file.name), ignored);
    }
  }

  void write() const {
    for (const auto& file : files_) {
      replaceable(directory_ / file.name);
      write_unfinished(unfinished_path(directory_, file.name), file.content);
    }
  }

  void publish() const {
    for (const auto& file : files_) {
      std::error_code error;
      fs::rename(unfinished_path(directory_, file.name), directory_ / file.name, error);
      if (error) {
        fail(directory_ / file.name, "cannot be written", error.message());
      }
    }
  }

 private:
  const fs::path& directory_;
  const std::vector<NamedContent>& files_;
};

}  // namespace

void create_run_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) {
    fail(directory, "the run directory cannot be made", error.message());
  }
  if (!fs::is_directory(directory, error)) {
    fail(directory, "the run directory cannot be made", "a file has this name");
  }
  const std::vector<NamedContent> attempt{{"attempt", ""}};
  UnfinishedFiles(directory, attempt).write();
}

void write_files(const fs::path& directory, const std::vector<NamedContent>& files) {
  const UnfinishedFiles unfinished(directory, files);
  unfinished.write();
  unfinished.publish();
}

fs::path place_of_result(const fs::path& place, const fs::path& folder) {
  return place.has_parent_path() ? place : folder / place;
}

std::string read_file(const fs::path& file) {
  if (std::error_code ignored; fs::is_directory(file, ignored)) {
    fail(file, "cannot be read", "it is a directory");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    fail(file, "cannot be read", std::strerror(errno));
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace maquette::sim
