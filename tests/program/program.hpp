#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace maquette::tests {

/// What a run of the program left behind.
struct Outcome {
  int exit_code;
  std::string output;
  std::string errors;
};

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A directory that goes away with its owner.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "maquette-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ScratchDirectory(ScratchDirectory&&) = delete;
  ScratchDirectory& operator=(ScratchDirectory&&) = delete;
  ~ScratchDirectory() { std::filesystem::remove_all(path_); }

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file and returns its path.
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

/// Runs maquette with arguments as a shell would split them.
inline Outcome run_maquette(const std::string& arguments) {
  const ScratchDirectory scratch;
  const std::string command = std::string(MAQUETTE_PROGRAM) + " " + arguments + " >" +
                              (scratch / "output").string() + " 2>" +
                              (scratch / "errors").string() + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          content_of(scratch / "output"), content_of(scratch / "errors")};
}

/// A scene that is quick to simulate and uses CSG, a mirror, glass and shadows.
inline const char* const k_small_scene = R"(name: small
view: {eye: [0, -6, 3], target: [0, 0, 0.4], up: [0, 0, 1], field_of_view: 30 deg}
lights:
  key: {position: [5, -6, 8], intensity: [2.5, 2.5, 2.5]}
ambient: [0.1, 0.1, 0.1]
background: [0, 0.1, 0.3]
surfaces:
  red: {diffuse: [0.8, 0.1, 0.1]}
  silver: {specular: 1, metal: {index: [0.15, 0.14, 0.13], extinction: [3.9, 3.2, 2.4]}, half_angle: 4 deg}
  glass: {specular: 1, index: 1.5, transparent: true, absorption: [0.5, 0.1, 0.1], half_angle: 2 deg}
object:
  union:
    - difference:
        - box: {size: [1, 1, 1]}
        - sphere: {radius: 0.6}
          place: {translate: [0.5, -0.5, 0.5]}
      surface: red
    - sphere: {radius: 0.4}
      surface: silver
      place: {translate: [-1, 0.2, 0]}
    - sphere: {radius: 0.3}
      surface: glass
      place: {translate: [0.9, -0.6, -0.1]}
)";

/// Makes the frame of a machine small.
inline const char* const k_small_frame =
    " --set frame_memory.width=160pixels --set frame_memory.height=120pixels ";

}  // namespace maquette::tests
