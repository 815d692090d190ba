#include "sim/report/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw DescriptionError(path.string() + ": cannot be written: " + reason);
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(path),
      unfinished_(path.parent_path() /
                  ("." + path.filename().string() + ".unfinished-" + std::to_string(::getpid()))) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    fail(path_, "a directory has this name");
  }
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
