#include "tools/benchmark/rows.hpp"

#include "firmware/arithmetic/counted.hpp"
#include "sim/database/frame_synthesis.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/scene/description_loader.hpp"
#include "tools/benchmark/child_process.hpp"
#include "tools/benchmark/median.hpp"

namespace maquette::benchmark {

namespace {

/// Repetitions in turn, A B A B ..., so that a change of the host's speed meets both.
constexpr int k_repetitions = 9;

sim::Description description_of(const Paths& paths) {
  sim::DescriptionSources sources;
  sources.scene_file = paths.scene;
  sources.data_directory = paths.models;
  return sim::load_description(sources);
}

template <class Real>
sim::PackedScene<Real> packed(const Paths& paths) {
  const sim::Description description = description_of(paths);
  const auto& memory = description.machine.parameters.frame_memory;
  return sim::packed_scene<Real>(description.scene, {memory.width, memory.height});
}

std::vector<std::string> simulation_command(const Paths& paths, int threads) {
  return {paths.program, "run",
          paths.scene,   "--quiet",
          "--threads",   std::to_string(threads),
          "--outdir",    paths.scratch + "/simulated"};
}

std::vector<std::string> plain_command(const Paths& paths) {
  return {paths.benchmark, "--plain", paths.scratch + "/plain"};
}

}  // namespace

void render_plain(const Paths& paths, const std::string& directory) {
  const sim::PreparedScene<float> scene(packed<float>(paths));
  sim::create_run_directory(directory);
  sim::write_files(directory, {{"frame.png", sim::encode_png(synthesized_frame(scene).picture)}});
}

void render_nothing(const std::string& directory) {
  sim::create_run_directory(directory);
  sim::write_files(directory, {{"frame.png", sim::encode_png({1, 1, {0}})}});
}

std::vector<Row> measure_simulation(const Paths& paths) {
  std::vector<double> ratios;
  std::vector<double> simulated_s;
  std::vector<double> plain_s;
  std::vector<double> empty_s;
  std::vector<double> memory;
  for (int i = 0; i < k_repetitions; ++i) {
    const ProcessUsage simulated = run_process(simulation_command(paths, 1));
    const ProcessUsage plain = run_process(plain_command(paths));
    const ProcessUsage empty = run_process({paths.benchmark, "--empty", paths.scratch + "/empty"});
    ratios.push_back(simulated.processor_time_s / plain.processor_time_s);
    simulated_s.push_back(simulated.processor_time_s);
    plain_s.push_back(plain.processor_time_s);
    empty_s.push_back(empty.processor_time_s);
    memory.push_back(simulated.peak_memory_bytes);
  }
  constexpr double k_mebibyte = 1024 * 1024;
  const double start_s = median(empty_s);
  return {
      {"simulation_over_plain", median(ratios), "1", std::nullopt,
       "whole process, four boards with exact arbitration, one thread, processor time"},
      {"simulation_over_plain_net", (median(simulated_s) - start_s) / (median(plain_s) - start_s),
       "1", std::nullopt, "the same less what an empty picture takes in both"},
      {"simulation_memory", median(memory) / k_mebibyte, "MiB", std::nullopt,
       "peak of the same process"}};
}

std::vector<Row> measure_two_threads(const Paths& paths) {
  std::vector<double> over_plain;
  std::vector<double> over_one;
  for (int i = 0; i < k_repetitions; ++i) {
    const ProcessUsage two = run_process(simulation_command(paths, 2));
    const ProcessUsage one = run_process(simulation_command(paths, 1));
    const ProcessUsage plain = run_process(plain_command(paths));
    over_plain.push_back(two.wall_time_s / plain.wall_time_s);
    over_one.push_back(two.wall_time_s / one.wall_time_s);
  }
  return {
      {"two_threads_over_plain", median(over_plain), "1", std::nullopt,
       "whole process with two threads, wall time, plain with one"},
      {"two_threads_over_one", median(over_one), "1", std::nullopt, "whole process, wall time"}};
}

std::vector<Row> measure_counting(const Paths& paths) {
  const sim::PreparedScene<float> plain_scene(packed<float>(paths));
  const sim::PreparedScene<firmware::Counted> counted_scene(packed<firmware::Counted>(paths));
  std::vector<double> ratios;
  std::vector<double> plain_rates;
  std::vector<double> counted_rates;
  for (int i = 0; i < k_repetitions; ++i) {
    const sim::SynthesizedFrame plain = synthesized_frame(plain_scene);
    const sim::SynthesizedFrame counted = synthesized_frame(counted_scene);
    ratios.push_back(counted.time_s / plain.time_s);
    plain_rates.push_back(static_cast<double>(plain.rays) / plain.time_s);
    counted_rates.push_back(static_cast<double>(counted.rays) / counted.time_s);
  }
  constexpr double k_million = 1e6;
  return {{"counted_over_plain", median(ratios), "1", std::nullopt,
           "synthesis alone, counting type against float"},
          {"plain_rays", median(plain_rates) / k_million, "Mrays/s", std::nullopt,
           "synthesis alone, float, one thread"},
          {"counted_rays", median(counted_rates) / k_million, "Mrays/s", std::nullopt,
           "synthesis alone, counting type, one thread"}};
}

}  // namespace maquette::benchmark
