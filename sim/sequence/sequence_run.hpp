#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/report/statistics.hpp"
#include "sim/run/simulation.hpp"
#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// What a sequence has come to: the statistics of its frames so far.
struct SequenceResult {
  std::vector<Statistics> frames;
  bool partial = false;  ///< interrupted before its end
};

/// Simulates the frames of a sequence one after the other on its machine. Each frame's boards hold
/// what the frame before left: the host loads only the words that differ. Each is written into the
/// directory when it is done: frame-NNNN.png and stats-NNNN.json. `show` is called with the number
/// of frames that are. Of the request, what is said of frames of their own counts for each.
/// Assumption: a frame begins when the host has the picture of the one before, and the phases of
/// refresh and of the video reader begin anew with it. This process must have no other threads.
/// Throws DescriptionError; frames are checked against the boards' RAM before the first runs.
SequenceResult run_sequence(const Description& description, const SimulationRequest& request,
                            const std::filesystem::path& directory,
                            const std::function<void(std::size_t done)>& show);

/// The numbers of a sequence as JSON: each frame's times, and their sums.
[[nodiscard]] std::string sequence_json(const SequenceResult& sequence);

/// The same as a text for people.
[[nodiscard]] std::string summarise_sequence(const SequenceResult& sequence);

}  // namespace maquette::sim
