#include "sim/record/record_file.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/record_text.hpp"

namespace maquette::fuzz {

void try_container(const std::string& input) {
  try {
    const std::string written = sim::encode_record(sim::decode_record(input, "record.exr"));
    try {
      require(sim::encode_record(sim::decode_record(written, "written.exr")) == written,
              "a record has other bytes when it is written again");
    } catch (const sim::DescriptionError& error) {
      throw BrokenLaw(std::string{"a record that was written is refused: "} + error.what());
    }
  } catch (const sim::DescriptionError&) {
    return;
  }
}

std::vector<std::string> container_seeds() {
  std::vector<std::string> seeds;
  for (const sim::RecordedFrame& frame : small_frames()) {
    seeds.push_back(sim::encode_record(frame));
  }
  return seeds;
}

}  // namespace maquette::fuzz
