#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "sim/database/frame_synthesis.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/scene/description_loader.hpp"
#include "tools/benchmark/child_process.hpp"
#include "tools/benchmark/peer_scenes.hpp"
#include "tools/benchmark/povray_text.hpp"
#include "tools/benchmark/rows.hpp"

/// Pictures against POV-Ray's of the same scenes.
namespace maquette::benchmark {

namespace {

constexpr const char* k_povray = "/usr/bin/povray";
/// In turn; the least of each counts, which a busy host disturbs least.
constexpr int k_repetitions = 7;

/// Processor time of the plain firmware: packing, preprocessing, synthesis.
double plain_s(const sim::Description& description) {
  const std::clock_t start = std::clock();
  const sim::PreparedScene<float> scene(
      sim::packed_scene<float>(description.scene, sim::picture_format_of(description.machine)));
  const sim::SynthesizedFrame frame = synthesized_frame(scene);
  const std::clock_t end = std::clock();
  return frame.rays > 0 ? static_cast<double>(end - start) / CLOCKS_PER_SEC : 0;
}

std::vector<Row> measure_peer(const Paths& paths, const PeerScene& peer) {
  sim::DescriptionSources sources;
  sources.scene_file = fmt::format("{}/{}.yaml", paths.peers, peer.file);
  sources.data_directory = paths.models;
  sim::Description description = sim::load_description(sources);
  peer.complete(description.scene);
  const auto& memory = description.machine.parameters.frame_memory;
  const std::string name = peer.name;
  sim::write_files(paths.scratch,
                   {{name + ".pov", povray_text(description.scene, memory.width, memory.height)}});
  const bool has_povray = std::filesystem::exists(k_povray);
  const std::vector<std::string> command{
      "/bin/sh", "-c",
      fmt::format("exec {0} +I{1}/{2}.pov +W{3} +H{4} -D -F -A +WT1 2>/dev/null", k_povray,
                  paths.scratch, name, memory.width, memory.height)};
  double plain = plain_s(description);
  double povray = has_povray ? run_process(command).user_time_s : 0;
  for (int i = 1; i < k_repetitions; ++i) {
    plain = std::min(plain, plain_s(description));
    if (has_povray) {
      povray = std::min(povray, run_process(command).user_time_s);
    }
  }
  std::vector<Row> rows{
      {name + "_frame", plain, "s", std::nullopt, peer.meaning + std::string(", plain firmware")}};
  if (has_povray) {
    rows.push_back({name + "_povray", povray, "s", std::nullopt,
                    "user time of POV-Ray for the same picture, one thread"});
    rows.push_back({name + "_over_povray", plain / povray, "1", peer.bound,
                    "processor time of the one over the other"});
  }
  return rows;
}

}  // namespace

std::vector<Row> measure_povray(const Paths& paths) {
  std::vector<Row> rows;
  for (const PeerScene& peer : peer_scenes()) {
    const std::vector<Row> of_peer = measure_peer(paths, peer);
    rows.insert(rows.end(), of_peer.begin(), of_peer.end());
  }
  return rows;
}

}  // namespace maquette::benchmark
