#include "sim/command_line/report_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "sim/command_line/common_options.hpp"
#include "sim/page/run_page.hpp"
#include "sim/report/output_check.hpp"
#include "sim/report/output_file.hpp"

namespace maquette::sim {

namespace {

struct ReportOptions {
  std::string directory;
  std::string output;
  bool quiet = false;
};

/// Refuses to write the page over what it is made of.
void check_output(const std::string& output, const RunFiles& run) {
  std::vector<InputFile> inputs;
  for (const NamedContent& file : run.files) {
    inputs.push_back({(std::filesystem::path(run.directory) / file.name).string(), {}});
  }
  check_outputs({{"--output", output}}, inputs, run.directory);
}

void report(const ReportOptions& options) {
  const RunFiles run = read_run_files(options.directory);
  const std::string output = options.output.empty()
                                 ? (std::filesystem::path(options.directory) / k_page_name).string()
                                 : options.output;
  check_output(output, run);
  const std::string page = run_page(run, data_directory());
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
  verb.add_option("DIR", options->directory, "directory of results, as `maquette run` writes it")
      ->required()
      ->type_name("DIR");
  verb.add_option("--output", options->output, "the page (default: report.html in DIR)")
      ->type_name("FILE");
  verb.add_flag("--quiet", options->quiet, "say nothing");
  add_footer(verb, {}, {"maquette report runs/photo4"});
  verb.callback([options] { report(*options); });
}

}  // namespace maquette::sim
