#include "sim/sweep/study_directory.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "sim/report/digest.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/report/unfinished.hpp"
#include "sim/sweep/study_description.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_points = "points";

void check_same_study(const fs::path& file, const std::string& identity) {
  if (identity_of(read_study(file.string())) != identity) {
    throw DescriptionError(file.string() +
                           ": another study lives in this directory; --outdir DIR chooses another "
                           "one, and its removal makes room");
  }
}

}  // namespace

StudyDirectory::StudyDirectory(const StudyPoints& points, fs::path path)
    : points_(points), path_(std::move(path)) {
  const std::string identity = identity_of(points.study());
  digest_ = sha1_of(identity.data(), identity.size());
  const fs::path file = path_ / k_study_file;
  std::error_code ignored;
  const std::string text = write_study(points.study());
  const bool exists = fs::exists(file, ignored);
  if (exists && read_file(file) != text) {
    check_same_study(file, identity);
  }
  create_run_directory(path_ / k_points);
  clear_unfinished(path_);
  clear_unfinished(path_ / k_points);
  write_files(path_, {{k_study_file, text}});
}

fs::path StudyDirectory::file_of(int point) const {
  return path_ / k_points / fmt::format("{:06}.json", point);
}

std::optional<PointResult> StudyDirectory::read(int point) const {
  const fs::path name = file_of(point);
  std::error_code ignored;
  if (!fs::exists(name, ignored)) {
    return std::nullopt;
  }
  PointFile file = parse_point(read_file(name), name.string());
  if (file.study != digest_) {
    throw DescriptionError(name.string() + ": this point belongs to another study");
  }
  return std::move(file.result);
}

bool StudyDirectory::is_finished(int point) const {
  const std::optional<PointResult> result = read(point);
  return result && result->statistics;
}

void StudyDirectory::write(int point, const PointResult& result) const {
  const fs::path file = file_of(point);
  write_files(
      file.parent_path(),
      {{file.filename().string(), point_json(point, points_.parameters(point), digest_, result)}});
}

}  // namespace maquette::sim
