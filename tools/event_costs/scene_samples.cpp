#include "tools/event_costs/scene_samples.hpp"

#include "sim/run/program_samples.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/scene/shipped_descriptions.hpp"

namespace maquette::costs {
namespace {

/// Of a small frame more of the pixels show what is rare.
const std::vector<std::string> k_overrides = {
    "frame_memory.width=192 pixels", "frame_memory.height=144 pixels", "board.allow_overflow=true"};

/// The sample with its calls in one class, and without what arithmetic in line takes by the table.
sim::CostSample with_calls_together(const sim::CostSample& sample,
                                    const models::ArithmeticCosts& arithmetic) {
  sim::CostSample result = sample;
  for (std::size_t i = 0; i < firmware::k_arithmetic_count; ++i) {
    result.work.counts[i] = 0;
  }
  for (std::size_t i = 0; i < firmware::k_arithmetic_count; ++i) {
    const std::uint32_t count = sample.work.counts[i];
    if (arithmetic.called[i]) {
      result.work[k_call] += count;
    } else {
      const models::OperationCost& cost = arithmetic.operations[i];
      result.taken.clocks -= cost.clocks * count;
      result.taken.reads -= cost.reads * count;
      result.taken.writes -= cost.writes * count;
    }
  }
  return result;
}

void weigh_alike(std::vector<sim::CostSample>& samples) {
  double sum = 0;
  for (const sim::CostSample& sample : samples) {
    sum += sample.taken.clocks;
  }
  const double mean = sum / static_cast<double>(samples.size());
  for (sim::CostSample& sample : samples) {
    sample.weight = 1 / (mean * mean * static_cast<double>(samples.size()));
  }
}

/// A scene of so many small copies of its object that rays are tested against boxes, which no
/// shipped scene needs.
sim::Scene many_copies(const sim::Scene& scene) {
  constexpr int k_side = 20;
  constexpr double k_apart = 4.0 / k_side;
  constexpr double k_middle = 0.5 * k_side;
  sim::Scene result = scene;
  result.object.children.clear();
  for (int row = 0; row < k_side; ++row) {
    for (int column = 0; column < k_side; ++column) {
      sim::Object copy = scene.object;
      const sim::Placement size(1.0 / k_side);
      const sim::Vector3 place{(column - k_middle) * k_apart, (row - k_middle) * k_apart, 0};
      copy.placement = {size[0], size[1], size[2], place};
      result.object.children.push_back(copy);
    }
  }
  return result;
}

std::vector<sim::CostSample> samples_of(const sim::Scene& scene, const sim::Machine& machine) {
  std::vector<sim::CostSample> samples;
  for (const sim::CostSample& sample : sim::program_samples(scene, machine)) {
    samples.push_back(with_calls_together(sample, machine.parameters.board.arithmetic));
  }
  weigh_alike(samples);
  return samples;
}

void add(const std::vector<sim::CostSample>& samples, std::vector<sim::CostSample>& all) {
  all.insert(all.end(), samples.begin(), samples.end());
}

}  // namespace

std::vector<sim::CostSample> samples_of_all_scenes(const std::string& data_directory) {
  std::vector<sim::CostSample> all;
  for (const sim::ShippedDescription& shipped :
       sim::shipped_descriptions(data_directory, "scenes")) {
    const sim::Description description = sim::load_description(
        {shipped.file, std::string{"ccett-1984"}, k_overrides, data_directory});
    add(samples_of(description.scene, description.machine), all);
    if (shipped.name == "union") {
      add(samples_of(many_copies(description.scene), description.machine), all);
    }
  }
  return all;
}

}  // namespace maquette::costs
