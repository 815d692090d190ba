#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/sweep/point_result.hpp"
#include "sim/sweep/study_points.hpp"

namespace maquette::sim {

inline constexpr const char* k_study_file = "study.yaml";

/// Where a study keeps what came of its points: study.yaml, points/NUMBER.json. Several processes
/// may use one directory at a time, each for points of its own.
class StudyDirectory {
 public:
  /// Makes the directory and writes study.yaml. Throws DescriptionError when it cannot be made,
  /// or when another study lives there.
  StudyDirectory(const StudyPoints& points, std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// What is stored of a point; nothing when it has not been run. Throws DescriptionError when the
  /// file is damaged or belongs to another study.
  [[nodiscard]] std::optional<PointResult> read(int point) const;

  /// Whether the point has statistics; a failed one has not. Throws as `read`.
  [[nodiscard]] bool is_finished(int point) const;

  /// Stores a point, whole or not at all.
  void write(int point, const PointResult& result) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(int point) const;

  const StudyPoints& points_;
  std::filesystem::path path_;
  std::string digest_;
};

}  // namespace maquette::sim
