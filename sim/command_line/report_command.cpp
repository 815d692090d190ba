#include "sim/command_line/report_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/command_line/common_options.hpp"
#include "sim/page/result_page.hpp"
#include "sim/page/run_page.hpp"
#include "sim/report/output_check.hpp"
#include "sim/report/output_file.hpp"

namespace maquette::sim {

namespace {

struct ReportOptions {
  std::vector<std::string> directories;
  std::string output;
  bool quiet = false;
};

/// Refuses to write the page over what it is made of.
void check_output(const std::string& output, const std::vector<std::string>& directories) {
  for (const std::string& directory : directories) {
    std::vector<InputFile> inputs;
    for (const char* name :
         {"stats.json", "config.yaml", "frame.png", "manifest.json", "maps.exr", "table.csv",
          "study.yaml", "accuracy.csv", "host_times.csv", "stability.json", "sequence.json"}) {
      inputs.push_back({(std::filesystem::path(directory) / name).string(), {}});
    }
    check_outputs({{"--output", output}}, inputs, directory);
  }
}

void report(const ReportOptions& options) {
  const std::filesystem::path first = options.directories.front();
  const std::string output = !options.output.empty()          ? options.output
                             : options.directories.size() > 1 ? (first / "comparison.html").string()
                                                              : (first / k_page_name).string();
  check_output(output, options.directories);
  const std::string page =
      result_page({options.directories.begin(), options.directories.end()}, data_directory());
  OutputFile file(output);
  file.stream() << page;
  file.publish();
  if (!options.quiet) {
    fmt::print("written: {}\n", output);
  }
}

}  // namespace

void add_report_command(CLI::App& program) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& verb = *program.add_subcommand(
      "report", "a page for a browser, one file: picture, times, bus, machine, configuration");
  verb.add_option("DIR", options->directories,
                  "directory of results of run, sweep, accuracy or stability; several runs are "
                  "compared with the first")
      ->required()
      ->type_name("DIR");
  verb.add_option(
          "--output", options->output,
          "the page (default: report.html in DIR, or comparison.html in the first of several)")
      ->type_name("FILE");
  verb.add_flag("--quiet", options->quiet, "say nothing");
  add_footer(verb, {}, {"maquette report runs/photo4", "maquette report runs/photo4 runs/eight"});
  verb.callback([options] { report(*options); });
}

}  // namespace maquette::sim
