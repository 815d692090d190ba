#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/yaml/input_file.hpp"

namespace maquette::sim {

/// A file that a run has read, and the SHA-1 of what it read.
struct InputDigest {
  std::string path;  ///< as the user gave it
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
  std::vector<InputDigest> inputs;
  std::vector<std::string> warnings;  ///< that the command was answered with
  std::vector<std::string> files;     ///< of the results, relative to the manifest
  double host_time_s = 0;             ///< wall clock
  double processor_time_s = 0;        ///< of all threads and child processes, user and system
  std::int64_t peak_memory_bytes = 0;
  std::int64_t peak_child_memory_bytes = 0;  ///< of the largest child process
  std::optional<StudyCost> study;
};

/// The digest of what was read of a file.
[[nodiscard]] InputDigest digest_of(const InputFile& file);

/// Fills in processor time and peak memory of this process and its children so far.
void measure_process(Manifest& manifest);

/// The text of manifest.json.
std::string manifest_json(const Manifest& manifest);

}  // namespace maquette::sim
