#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace maquette::sim {

/// A file that is written piece by piece beside its name and renamed when it is complete, so nobody
/// ever finds half of it; without `publish` nothing is left. What killed commands left of such a
/// file is cleared by the next that begins it.
class OutputFile {
 public:
  /// Begins the file. Throws DescriptionError when there is no such directory or no permission.
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// Gives the file its name. Throws DescriptionError when not all of it could be written.
  void publish();

 private:
  std::filesystem::path path_;
  std::filesystem::path unfinished_;
  std::ofstream stream_;
};

}  // namespace maquette::sim
