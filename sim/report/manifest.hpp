#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace maquette::sim {

/// A file that a run has read: its path as the user gave it, and the SHA-1 of its bytes.
struct InputFile {
  std::string path;
  std::string sha1;  ///< 40 hexadecimal digits
};

/// What simulating the points of a study cost.
struct StudyCost {
  int jobs = 1;    ///< processes at a time
  int points = 0;  ///< simulated by this command
};

/// Where a result comes from, and what it cost on the host. The one output that differs between
/// equal runs.
struct Manifest {
  std::vector<std::string> command;  ///< the arguments, program name first
  std::string version;
  std::string revision;  ///< of the sources
  std::vector<InputFile> inputs;
  double host_time_s = 0;       ///< wall clock
  double processor_time_s = 0;  ///< of all threads and child processes, user and system
  std::int64_t peak_memory_bytes = 0;
  std::int64_t peak_child_memory_bytes = 0;  ///< of the largest child process
  std::optional<StudyCost> study;
};

/// Hashes a file. Throws DescriptionError when it cannot be read.
InputFile hash_input(const std::string& path);

/// Fills in processor time and peak memory of this process and its children so far.
void measure_process(Manifest& manifest);

/// The text of manifest.json.
std::string manifest_json(const Manifest& manifest);

}  // namespace maquette::sim
