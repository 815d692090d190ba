#include "sim/report/replaceable.hpp"

#include <string>
#include <system_error>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

std::string name_of(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "a directory has this name";
    case fs::file_type::symlink:
      return "a link to nothing has this name";
    default:
      return "what has this name is no regular file";
  }
}

}  // namespace

fs::path replaceable(const fs::path& path) {
  // Another process may put a file there at any time: nothing is asked twice.
  std::error_code error;
  const fs::file_type own = fs::symlink_status(path, error).type();
  if (own == fs::file_type::not_found || own == fs::file_type::none ||
      own == fs::file_type::regular) {
    return path;
  }
  const fs::file_type target = own == fs::file_type::symlink ? fs::status(path, error).type() : own;
  if (target == fs::file_type::regular) {
    const fs::path place = fs::canonical(path, error);
    return error ? path : place;
  }
  throw DescriptionError(path.string() + ": cannot be written: " +
                         name_of(target == fs::file_type::not_found ? own : target));
}

}  // namespace maquette::sim
