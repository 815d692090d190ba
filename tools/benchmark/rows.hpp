#pragma once

#include <optional>
#include <string>
#include <vector>

namespace maquette::benchmark {

/// One measured figure.
struct Row {
  std::string name;
  double value;
  std::string unit;             ///< "1" for a ratio
  std::optional<double> bound;  ///< the value should not exceed it
  std::string meaning;
};

/// Where programs and scenes are.
struct Paths {
  std::string program;    ///< maquette
  std::string benchmark;  ///< this program, which can render a plain frame
  std::string scene;
  std::string peers;  ///< the directory of scenes that are compared with POV-Ray
  std::string models;
  std::string scratch;  ///< a directory of its own
};

/// Whole processes, one thread: simulation of the frame against the plain firmware rendering it.
std::vector<Row> measure_simulation(const Paths& paths);

/// The same with two threads.
std::vector<Row> measure_two_threads(const Paths& paths);

/// The same with the bus as lines, against the bus as accesses.
std::vector<Row> measure_bus_levels(const Paths& paths);

/// The machine with function units against the one without.
std::vector<Row> measure_units(const Paths& paths);

/// Boards that execute their program, against counted work and what its calibration takes.
std::vector<Row> measure_processor(const Paths& paths);

/// A study of one recorded frame, with a process per processor: what a machine variation costs.
std::vector<Row> measure_sweep(const Paths& paths);

/// Synthesis alone, in this process: counting type against float.
std::vector<Row> measure_counting(const Paths& paths);

/// Rays against surfaces of revolution, in this process.
std::vector<Row> measure_revolution(const Paths& paths);

/// Rays against terrains of several levels, in this process.
std::vector<Row> measure_terrain(const Paths& paths);

/// Rays in unions of 100 to 100 000 bodies, in this process.
std::vector<Row> measure_unions(const Paths& paths);

/// Pictures of the plain firmware against POV-Ray, where it is installed.
std::vector<Row> measure_povray(const Paths& paths);

/// Rays against the patches of the teapot, in this process.
std::vector<Row> measure_patches(const Paths& paths);

/// Pages, maps and films: what they take beyond the run, or from its record.
std::vector<Row> measure_viewing(const Paths& paths);

/// Writes a picture of one pixel: what a process costs before it renders anything.
void render_nothing(const std::string& directory);

/// Renders the scene with the plain float firmware and writes the picture.
void render_plain(const Paths& paths, const std::string& directory);

}  // namespace maquette::benchmark
