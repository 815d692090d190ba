#pragma once

#include <filesystem>

#include "sim/machine/machine.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// The key of a scene's record for a machine.
RecordKey record_key_of(const Scene& scene, const Machine& machine);

/// The record in a file. Throws DescriptionError when it cannot be read, or is not one of `wanted`.
RecordedFrame load_record(const std::filesystem::path& file, const RecordKey& wanted);

/// Writes a record beside its name, then renames it; makes missing directories. Throws
/// DescriptionError.
void save_record(const std::filesystem::path& file, const RecordedFrame& record);

/// Where a directory of records keeps the one of a key.
std::filesystem::path record_file(const std::filesystem::path& directory, const RecordKey& key);

/// The record of a scene from a directory of records, which is synthesised on `threads` threads and
/// kept there when it is missing, or lacks the legs that the machine wants. Throws
/// DescriptionError.
RecordedFrame record_of(const Scene& scene, const Machine& machine,
                        const std::filesystem::path& directory, int threads);

}  // namespace maquette::sim
