#include "sim/command_line/compare_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "sim/command_line/common_options.hpp"
#include "sim/report/compare.hpp"

namespace maquette::sim {

void add_compare_command(CLI::App& program, int& exit_code) {
  struct Directories {
    std::string first;
    std::string second;
  };
  const auto directories = std::make_shared<Directories>();
  CLI::App& verb = *program.add_subcommand(
      "compare", "what differs between two runs: configuration, statistics, picture");
  verb.add_option("FIRST", directories->first, "run directory")->required()->type_name("DIR");
  verb.add_option("SECOND", directories->second, "run directory")->required()->type_name("DIR");
  add_footer(verb, {}, {"maquette compare runs/photo4 runs/eight"});
  verb.callback([directories, &exit_code] {
    const RunComparison comparison = compare_runs(directories->first, directories->second);
    fmt::print("{}\n", comparison_report(comparison));
    exit_code = comparison.equal() ? 0 : 1;
  });
}

}  // namespace maquette::sim
