#include "sim/command_line/run_options.hpp"

namespace maquette::sim {
namespace {

/// A point of a study is a whole description: nothing else describes what is run.
void add_point_options(CLI::App& verb, RunOptions& options) {
  CLI::Option* point =
      verb.add_option("--point", options.point, "the point of --sweep to run, from 0")
          ->type_name("N")
          ->check(CLI::NonNegativeNumber);
  CLI::Option* study =
      verb.add_option("--sweep", options.study,
                      "run a point of this study, its file or the name of a shipped one, in place "
                      "of a scene: study.yaml in the directory of a sweep has all of its points")
          ->type_name("FILE|STUDY");
  study->needs(point);
  point->needs(study);
  for (const char* other : {"SCENE", "--machine", "--set", "--bus", "--quantum"}) {
    study->excludes(verb.get_option(other));
  }
}

}  // namespace

void add_run_options(CLI::App& verb, RunOptions& options) {
  add_common_options(verb, options.common);
  verb.get_option("SCENE")->required(false);
  verb.add_option("--outdir", options.outdir,
                  "run directory (default: runs/NAME-OF-SCENE, or runs/STUDY-pointN)")
      ->type_name("DIR");
  verb.add_option(
          "--processor", options.processor,
          "what the boards do: their work counted, a recorded frame's work replayed, or their "
          "program executed instruction by instruction")
      ->check(CLI::IsMember({"counted", "recorded", "instruction"}))
      ->capture_default_str();
  verb.add_option("--record", options.record,
                  "OpenEXR file for the work of every pixel: written by --processor counted, "
                  "replayed by --processor recorded (default there: one in the run directory, made "
                  "when it is missing)")
      ->type_name("FILE");
  add_bus_options(verb, options.bus);
  add_point_options(verb, options);
  verb.add_option("--threads", options.threads,
                  "host threads that synthesise (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  verb.add_option("--frame", options.frame,
                  "simulate this frame of the scene's sequence alone, from 0, on boards that hold "
                  "the one before (default: all)")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--snapshot", options.snapshots,
                  "write the frame memory as it is at this simulated time, e.g. \"60 s\" or "
                  "\"6 min 59 s\" "
                  "(repeatable)")
      ->type_name("TIME")
      ->expected(1)
      ->take_all();
  verb.add_option("--snapshot-shown", options.shown_snapshots,
                  "write what the video reader shows at this simulated time (repeatable)")
      ->type_name("TIME")
      ->expected(1)
      ->take_all();
  add_film_options(verb, options.film);
  verb.add_option("--map", options.maps,
                  "write a map of the pixels, e.g. time, board, rays, surface, as map-NAME.png and "
                  "in maps.exr; `maquette describe --maps` lists them (repeatable)")
      ->type_name("NAME")
      ->expected(1)
      ->take_all();
  verb.add_option(
          "--dump-ram", options.dumped_boards,
          "write the RAM of this board as it is at the end, ram-BOARD.bin, and where things "
          "are in it, ram.map; with --processor instruction (repeatable)")
      ->type_name("BOARD")
      ->expected(1)
      ->take_all();
  verb.add_option(
          "--trace", options.trace.files,
          "write what happens on the bus: .json for ui.perfetto.dev, .vcd for GTKWave with a "
          "save file beside it, .svg as a chart for a slide; a name alone is put into the run "
          "directory (repeatable)")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
  verb.add_option("--trace-lines", options.trace.lines,
                  "write what the lines of the backplane show, as a .vcd for GTKWave; with --bus "
                  "signal, which simulates them")
      ->type_name("FILE");
  verb.add_flag("--trace-video", options.trace.video,
                "show fields, lines and slots of the video reader in the traces as well, and the "
                "accesses that wait for it");
  verb.add_option("--trace-window", options.trace.window,
                  "trace only this part of the frame, e.g. \"1 s..1.01 s\"; either may be left out")
      ->type_name("T0..T1");
  verb.add_option(
          "--trace-boards", options.trace.boards,
          "give only these boards, behind which units are numbered on, tracks of their own, e.g. "
          "0,2..3")
      ->type_name("LIST");
  verb.add_flag("--report", options.report,
                "write report.html, a page for a browser that shows all results");
  verb.add_flag("--quiet", options.quiet, "neither progress nor summary");
}

std::filesystem::path run_directory_of(const RunOptions& options, const Description& description) {
  return options.outdir.empty() ? default_directory(options.common, description.scene, "")
                                : std::filesystem::path(options.outdir);
}

}  // namespace maquette::sim
