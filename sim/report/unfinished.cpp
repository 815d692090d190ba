#include "sim/report/unfinished.hpp"

#include <unistd.h>
#include <csignal>

#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>
#include <vector>

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_mark = ".unfinished-";

/// Process numbers mean something on their own host only; several may share a directory.
std::string mark_of_host() {
  std::array<char, 256> name{};
  const bool has_name = ::gethostname(name.data(), name.size() - 1) == 0;
  return std::string{k_mark} + (has_name ? name.data() : "host") + "-";
}

bool is_running(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

/// Whether a file has the name of what a process of this host left unfinished.
bool is_left(const std::string& file, const std::string& name) {
  const std::string mark = mark_of_host();
  const std::size_t place = file.rfind(mark);
  if (place == std::string::npos || place == 0 || file.front() != '.' ||
      (!name.empty() && file.compare(1, place - 1, name) != 0)) {
    return false;
  }
  const char* const end = file.data() + file.size();
  pid_t process = 0;
  const auto number = std::from_chars(file.data() + place + mark.size(), end, process);
  return number.ec == std::errc{} && number.ptr == end && process > 0 && !is_running(process);
}

}  // namespace

std::string unfinished_name(const std::string& name) {
  return "." + name + mark_of_host() + std::to_string(::getpid());
}

void clear_unfinished(const fs::path& directory, const std::string& name) {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, ignored)) {
    if (is_left(entry.path().filename().string(), name)) {
      left.push_back(entry.path());
    }
  }
  for (const fs::path& path : left) {
    fs::remove_all(path, ignored);
  }
}

}  // namespace maquette::sim
