#include "sim/command_line/stability_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/table_output.hpp"
#include "sim/report/progress.hpp"
#include "sim/report/result_directory.hpp"
#include "sim/stability/stability_checks.hpp"
#include "sim/stability/stability_report.hpp"

namespace maquette::sim {

namespace {

struct StabilityOptions {
  std::vector<std::string> scalars;
  std::vector<std::string> groups;
  std::string scenes = data_directory() + "/scenes";
  std::string outdir = "runs/stability";
  bool quiet = false;
  TableFormat format = TableFormat::text;
};

void add_options(CLI::App& verb, StabilityOptions& options) {
  verb.add_option("--scalar", options.scalars, "number type that is tried (default: both)")
      ->check(CLI::IsMember({"float", "double"}))
      ->delimiter(',');
  verb.add_option("--only", options.groups, "groups of checks, e.g. roots,scale (default: all)")
      ->check(CLI::IsMember(stability_groups()))
      ->delimiter(',');
  verb.add_option("--scenes", options.scenes,
                  "directory of the scenes that are tried (default: those shipped)")
      ->type_name("DIR");
  verb.add_option("--outdir", options.outdir, "directory of the results")
      ->type_name("DIR")
      ->capture_default_str();
  verb.add_flag("--quiet", options.quiet, "neither progress nor table");
  add_format_option(verb, options.format);
}

bool is_wanted(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

/// The checks of one number type that are wanted.
struct Plan {
  std::string scalar;
  std::vector<StabilityCheck> checks;
};

template <class Real>
void add_plan(const std::string& scalar, const StabilityOptions& options,
              const StabilityMaterial& material, std::vector<Plan>& plans) {
  if (!is_wanted(options.scalars, scalar)) {
    return;
  }
  Plan plan{scalar, {}};
  for (StabilityCheck& check : stability_checks<Real>(material, 1)) {
    if (is_wanted(options.groups, check.group)) {
      plan.checks.push_back(std::move(check));
    }
  }
  plans.push_back(std::move(plan));
}

std::vector<StabilityMeasurement> measure(const std::vector<Plan>& plans, bool quiet) {
  int planned = 0;
  for (const Plan& plan : plans) {
    planned += static_cast<int>(plan.checks.size());
  }
  Progress progress(!quiet);
  int done = 0;
  std::vector<StabilityMeasurement> measurements;
  for (const Plan& plan : plans) {
    StabilityMeasurement& measurement = measurements.emplace_back();
    measurement.scalar = plan.scalar;
    for (const StabilityCheck& check : plan.checks) {
      progress.show_checks(done++, planned, plan.scalar + " " + check.group);
      for (StabilityRow& row : check.measure()) {
        measurement.rows.push_back(std::move(row));
      }
    }
  }
  return measurements;
}

Table row_table(const std::vector<StabilityMeasurement>& measurements) {
  Table table;
  for (const char* name : {"scalar", "group", "subject", "counted", "value", "bound", "holds"}) {
    table.columns.push_back({name, "", ""});
  }
  for (const StabilityMeasurement& measurement : measurements) {
    for (const StabilityRow& row : measurement.rows) {
      table.rows.push_back(
          {measurement.scalar, row.group, row.subject, row.counted, fmt::format("{}", row.value),
           row.bound ? fmt::format("{}", *row.bound) : "", row.holds() ? "yes" : "no"});
    }
  }
  return table;
}

int stability(const StabilityOptions& options, const std::vector<std::string>& command) {
  const auto start = std::chrono::steady_clock::now();
  const std::string exact_roots_file = data_directory() + "/stability/exact_roots.txt";
  const StabilityMaterial material = stability_material(options.scenes, exact_roots_file);
  ResultDirectory results(options.outdir);
  std::vector<Plan> plans;
  add_plan<float>("float", options, material, plans);
  add_plan<double>("double", options, material, plans);
  const std::vector<StabilityMeasurement> measurements = measure(plans, options.quiet);
  const std::chrono::duration<double> host_time = std::chrono::steady_clock::now() - start;
  std::vector<InputFile> input_files{read_input(exact_roots_file)};
  for (const ShippedScene& scene : material.scenes) {
    input_files.push_back(scene.file);
  }
  write_files(results.workplace(), {{"stability.json", stability_json(measurements)}});
  results.publish(manifest_of(command, input_files, host_time.count()));
  const int broken = broken_bounds(measurements);
  if (!options.quiet) {
    fmt::print("{}", in_format(
                         options.format,
                         [&] {
                           return fmt::format(
                               "{}\n{}\nwritten: {}\n", stability_table(measurements),
                               broken == 0 ? "every bound holds"
                                           : fmt::format("{} bounds are broken (!)", broken),
                               options.outdir);
                         },
                         [&] { return row_table(measurements); }));
  }
  return broken == 0 ? 0 : 1;
}

}  // namespace

void add_stability_command(CLI::App& program, const std::vector<std::string>& command,
                           int& exit_code) {
  const auto options = std::make_shared<StabilityOptions>();
  CLI::App& verb = *program.add_subcommand("stability",
                                           "how far to trust the numbers: extreme machines, roots, "
                                           "scale, secondary rays, solids, extreme "
                                           "inputs");
  add_footer(verb, "The exit code is 1 when a bound is broken.",
             {"maquette stability --only roots,scale"});
  add_options(verb, *options);
  verb.callback([options, &command, &exit_code] { exit_code = stability(*options, command); });
}

}  // namespace maquette::sim
