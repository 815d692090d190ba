#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/yaml/input_file.hpp"

namespace maquette::sim {

/// A file that a command is told to write, and by which option.
struct RequestedOutput {
  std::string option;
  std::filesystem::path path;
};

/// Makes sure that what a command is told to write may be replaced: it is no file that the command
/// reads, no other output, no result of the run directory `results`, and nothing but a regular
/// file. Throws DescriptionError.
void check_outputs(const std::vector<RequestedOutput>& outputs,
                   const std::vector<InputFile>& inputs, const std::filesystem::path& results);

}  // namespace maquette::sim
