#pragma once

#include <string>

#include "sim/record/recorded_frame.hpp"

namespace maquette::sim {

/// A recorded frame as the bytes of an OpenEXR file that any viewer shows: the display window is
/// the frame, the data window the useful zone; channels R, G, B (halves, code / 255, no transfer
/// curve), `depth` (codes), `rays.KIND` and `work.OPERATION` (32-bit whole numbers; work.load
/// counts the reads of the database, work.store the writes of work areas). The header says what it
/// is a record of. Throws std::runtime_error when the picture module fails.
std::string encode_record(const RecordedFrame& frame);

/// The frame in the bytes of such a file. `name` is that of the file, for messages. Throws
/// DescriptionError for a file that is none, or is damaged.
RecordedFrame decode_record(const std::string& bytes, const std::string& name);

/// Throws DescriptionError when the record `name` is not one of `wanted`: another scene, size or
/// firmware.
void check_record(const RecordKey& wanted, const RecordKey& found, const std::string& name);

}  // namespace maquette::sim
