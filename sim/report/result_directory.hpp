#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/report/manifest.hpp"
#include "sim/report/run_directory.hpp"

namespace maquette::sim {

/// A directory of results that appears whole or not at all. What comes of a command is gathered in
/// a hidden workplace; a directory that is not there yet is that workplace under its new name. In
/// one that is there the results replace those of the command before, file by file, the manifest
/// last: without a manifest nobody takes them for whole. What is not of a command stays.
class ResultDirectory {
 public:
  /// Makes the workplace, so that a command does not find out at its end that nothing can be
  /// written, and clears what killed commands left. Throws DescriptionError.
  explicit ResultDirectory(std::filesystem::path directory);
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;
  ResultDirectory(ResultDirectory&&) = delete;
  ResultDirectory& operator=(ResultDirectory&&) = delete;

  /// Leaves nothing behind that was not published, nor a directory that is empty.
  ~ResultDirectory();

  /// Where files are gathered, also in folders of their own.
  [[nodiscard]] const std::filesystem::path& workplace() const { return workplace_; }

  /// A folder whose files stay when later commands publish into the same directory.
  [[nodiscard]] std::filesystem::path kept(const std::string& name);

  /// Publishes all that was gathered, and the manifest with its names. Throws DescriptionError.
  void publish(Manifest manifest);

 private:
  void publish_within();

  std::filesystem::path directory_;
  bool is_new_;
  std::filesystem::path workplace_;
  std::vector<std::filesystem::path> made_;  // directories above, the innermost first
  std::vector<std::string> kept_;
};

}  // namespace maquette::sim
