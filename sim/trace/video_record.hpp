#pragma once

#include <cstdint>
#include <vector>

#include "models/bus/instant.hpp"

namespace maquette::sim {

/// A field of the video reader within a window.
struct RecordedField {
  models::Instant from;
  models::Instant to;
  int field;  ///< 1 or 2
};

/// A line of it.
struct RecordedLine {
  models::Instant from;
  models::Instant to;
  int line;  ///< of the standard, from 1
  int row;   ///< of the picture, or -1 on a line that shows none
};

/// An access to the frame memory that had to wait for a slot of the reader.
struct RecordedDelay {
  models::Instant from;
  models::Instant to;
};

/// What the video reader did during a window of a frame: fields and lines tile it, each cut at its
/// edges; delays lie within it, in any order. Instants count from the frame's start.
struct VideoRecord {
  std::vector<RecordedField> fields;
  std::vector<RecordedLine> lines;
  std::vector<RecordedDelay> delays;
};

}  // namespace maquette::sim
