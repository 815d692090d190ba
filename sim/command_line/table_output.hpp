#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "sim/report/table.hpp"

namespace maquette::sim {

/// How a verb prints its table: laid out for people, or for programs.
enum class TableFormat { text, json, csv };

/// Adds --format to a verb.
void add_format_option(CLI::App& verb, TableFormat& format);

/// The table as a list of objects: cells that are numbers as numbers, empty ones as null.
[[nodiscard]] std::string table_json(const Table& table);

/// What a verb prints: its text for people, or its table; only that is made.
[[nodiscard]] std::string in_format(TableFormat format, const std::function<std::string()>& text,
                                    const std::function<Table()>& table);

}  // namespace maquette::sim
