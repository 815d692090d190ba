#pragma once

#include <string>

#include "sim/report/table.hpp"
#include "sim/yaml/input_file.hpp"

namespace maquette::sim {

/// Whether the file describes a study: it varies something. Throws DescriptionError when it is no
/// YAML.
[[nodiscard]] bool describes_study(const InputFile& file);

/// What a study asks, what it varies, and the columns of its table that it adds, for people. Throws
/// DescriptionError.
[[nodiscard]] std::string study_report(const InputFile& file);

/// All columns of its table, which plots take. Throws DescriptionError.
[[nodiscard]] Table column_table(const InputFile& file);

}  // namespace maquette::sim
