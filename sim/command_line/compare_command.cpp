#include "sim/command_line/compare_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/table_output.hpp"
#include "sim/report/compare.hpp"

namespace maquette::sim {

namespace {

void add(Table& table, const std::string& of, const std::vector<ValueDifference>& differences) {
  for (const ValueDifference& one : differences) {
    table.rows.push_back({of, one.path, one.first.value_or(""), one.second.value_or(""),
                          one.relative ? fmt::format("{}", *one.relative) : ""});
  }
}

/// The values that differ; of the pictures the pixels.
Table difference_table(const RunComparison& comparison) {
  Table table;
  for (const char* name : {"of", "path", "first", "second", "relative"}) {
    table.columns.push_back({name, "", ""});
  }
  add(table, "configuration", comparison.configuration);
  add(table, "statistics", comparison.statistics);
  if (comparison.picture.pixels > 0) {
    table.rows.push_back(
        {"picture", "pixels that differ", "0", fmt::format("{}", comparison.picture.pixels), ""});
  }
  return table;
}

}  // namespace

void add_compare_command(CLI::App& program, int& exit_code) {
  struct Directories {
    std::string first;
    std::string second;
    TableFormat format = TableFormat::text;
  };
  const auto directories = std::make_shared<Directories>();
  CLI::App& verb = *program.add_subcommand(
      "compare", "what differs between two runs: configuration, statistics, picture");
  verb.add_option("FIRST", directories->first, "run directory")->required()->type_name("DIR");
  verb.add_option("SECOND", directories->second, "run directory")->required()->type_name("DIR");
  add_format_option(verb, directories->format);
  add_footer(verb, {}, {"maquette compare runs/photo4 runs/eight"});
  verb.callback([directories, &exit_code] {
    const RunComparison comparison = compare_runs(directories->first, directories->second);
    fmt::print("{}", in_format(
                         directories->format, [&] { return comparison_report(comparison) + "\n"; },
                         [&] { return difference_table(comparison); }));
    exit_code = comparison.equal() ? 0 : 1;
  });
}

}  // namespace maquette::sim
