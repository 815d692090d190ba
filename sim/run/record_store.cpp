#include "sim/run/record_store.hpp"

#include "sim/record/record_file.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/run/frame_recorder.hpp"

namespace maquette::sim {

RecordKey record_key_of(const Scene& scene, const Machine& machine) {
  return record_key_of(packed_scene<float>(scene, picture_format_of(machine)));
}

RecordedFrame load_record(const std::filesystem::path& file, const RecordKey& wanted) {
  RecordedFrame record = decode_record(read_file(file), file.string());
  check_record(wanted, record.key, file.string());
  return record;
}

void save_record(const std::filesystem::path& file, const RecordedFrame& record) {
  const std::filesystem::path directory = file.has_parent_path() ? file.parent_path() : ".";
  create_run_directory(directory);
  write_files(directory, {{file.filename().string(), encode_record(record)}});
}

std::filesystem::path record_file(const std::filesystem::path& directory, const RecordKey& key) {
  return directory / (key.name() + ".exr");
}

RecordedFrame record_of(const Scene& scene, const Machine& machine,
                        const std::filesystem::path& directory, int threads) {
  const RecordKey key = record_key_of(scene, machine);
  const std::filesystem::path file = record_file(directory, key);
  if (std::filesystem::exists(file)) {
    RecordedFrame kept = load_record(file, key);
    if (legs_wanted(machine) == LegsOfPixels::untold || kept.has_legs()) {
      return kept;
    }
  }
  RecordedFrame record = record_frame(scene, picture_format_of(machine), threads,
                                      FunctionsOfPixels::told, legs_wanted(machine));
  save_record(file, record);
  return record;
}

}  // namespace maquette::sim
