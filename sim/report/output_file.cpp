#include "sim/report/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "sim/report/replaceable.hpp"
#include "sim/report/unfinished.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw DescriptionError(path.string() + ": cannot be written: " + reason);
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(replaceable(path)),
      unfinished_(path_.parent_path() / unfinished_name(path_.filename().string())) {
  clear_unfinished(path_.has_parent_path() ? path_.parent_path() : ".", path_.filename().string());
  stream_.open(unfinished_, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    fail(path_, std::strerror(errno));
  }
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  std::filesystem::remove(unfinished_, ignored);
}

void OutputFile::publish() {
  stream_.close();
  if (!stream_) {
    fail(path_, std::strerror(errno));
  }
  std::error_code error;
  std::filesystem::rename(unfinished_, path_, error);
  if (error) {
    fail(path_, error.message());
  }
}

}  // namespace maquette::sim
