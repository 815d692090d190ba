#pragma once

#include <string>
#include <vector>

#include "sim/sweep/study.hpp"

namespace maquette::sim {

/// Reads a study file; files that it names are not read yet. Throws DescriptionError.
[[nodiscard]] Study read_study(const std::string& file);

/// The same for a document that was read.
[[nodiscard]] Study read_study(const YamlNode& root);

/// Puts every file that the study names in its place, so that the study needs no other file, and
/// checks that no parameter is given twice. A whole machine, scene or cost table among the values
/// of an axis keeps its name there. `input_files` gets what was read. Throws DescriptionError.
void inline_files(Study& study, const std::string& data_directory,
                  std::vector<InputFile>& input_files);

/// The study as a file that read_study reads back.
[[nodiscard]] std::string write_study(Study study);

/// What decides the points and their results: studies that share it can share a directory.
[[nodiscard]] std::string identity_of(Study study);

}  // namespace maquette::sim
