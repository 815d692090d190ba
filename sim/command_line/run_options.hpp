#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/film_output.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/trace/trace_request.hpp"

namespace maquette::sim {

/// What the verb `run` is told.
struct RunOptions {
  CommonOptions common;
  std::string study;  ///< whose point is run in place of a scene
  int point = -1;     ///< of the study
  std::string outdir;
  std::string processor = "counted";
  std::string record;
  BusOptions bus;
  int threads = 0;
  std::vector<std::string> snapshots;
  std::vector<std::string> shown_snapshots;
  std::vector<std::string> maps;
  FilmOptions film;
  std::vector<int> dumped_boards;
  TraceOptions trace;
  int frame = -1;  ///< of a sequence; all
  bool report = false;
  bool quiet = false;
};

void add_run_options(CLI::App& verb, RunOptions& options);

/// Where the results go: what was asked for, or a folder of the scene's name.
[[nodiscard]] std::filesystem::path run_directory_of(const RunOptions& options,
                                                     const Description& description);

}  // namespace maquette::sim
