#pragma once

#include <string>

#include "sim/report/table.hpp"
#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// Whether a shipped cost table, of arithmetic or of a program's events, has this name, and nothing
/// else that can be described.
[[nodiscard]] bool names_cost_table(const std::string& name, const std::string& data_directory);

/// What the shipped tables of a name say of each operation, and where that comes from.
[[nodiscard]] Table cost_table(const std::string& name, const DescriptionSources& sources);

/// The same for people.
[[nodiscard]] std::string cost_table_report(const std::string& name,
                                            const DescriptionSources& sources);

}  // namespace maquette::sim
