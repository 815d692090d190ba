#include "sim/database/unit_database.hpp"

#include <cstddef>
#include <type_traits>

#include "firmware/layout.hpp"
#include "sim/database/board_image.hpp"
#include "sim/database/ram_layout.hpp"

namespace maquette::sim {

namespace {

using models::UnitKind;

template <class Structure>
std::int64_t bytes_of(const Structure* /*first*/, std::size_t count) {
  return static_cast<std::int64_t>(count) * firmware::board_bytes<Structure>();
}

/// Which arrays of a scene units of a kind read.
struct Reads {
  bool leaves;
  bool composites;
  bool parameters;
  bool appearance;  ///< surfaces, lights, textures
};

constexpr Reads reads_of(UnitKind kind) {
  switch (kind) {
    case UnitKind::extents:
      return {true, true, false, false};
    case UnitKind::intersection:
      return {true, false, true, false};
    case UnitKind::combination:
      return {false, true, false, false};
    case UnitKind::photometry:
      return {true, false, true, true};
    case UnitKind::secondary_rays:
      break;
  }
  return {true, true, true, true};
}

bool is_read(const void* array, const Reads& reads, const firmware::Database<float>& database,
             const firmware::Conversion<float>& conversion) {
  if (array == database.leaves) {
    return reads.leaves;
  }
  if (array == database.composites) {
    return reads.composites;
  }
  if (array == database.parameters || array == conversion.given) {
    return reads.parameters;
  }
  return reads.appearance;
}

std::int64_t prepared_bytes(UnitKind kind, const firmware::Frame<float>& frame) {
  const firmware::Database<float>& database = frame.database;
  const Reads reads = reads_of(kind);
  std::int64_t bytes = 0;
  if (reads.parameters) {
    bytes += bytes_of(frame.prepared.leaves, database.leaf_count);
  }
  if (reads.leaves && reads.composites) {
    bytes += bytes_of(frame.prepared.extents, database.node_count());
  }
  if (reads.appearance) {
    bytes += bytes_of(frame.prepared.surfaces, database.surface_count) +
             2 * bytes_of(frame.prepared.light_positions, database.light_count);
  }
  return bytes;
}

}  // namespace

UnitDatabase unit_database(UnitKind kind, const PackedScene<float>& scene,
                           firmware::NumberFormat numbers) {
  firmware::Frame<float> frame{};
  frame.database = scene.database();
  const firmware::Conversion<float> conversion = scene.conversion();
  const std::vector<unsigned char> all = database_image(scene, numbers);
  const Reads reads = reads_of(kind);
  UnitDatabase result;
  auto from = all.begin();
  for_each_array(frame.database, conversion, [&](const auto* first, std::size_t count) {
    const auto end = from + bytes_of(first, count);
    if (is_read(first, reads, frame.database, conversion)) {
      result.loaded.insert(result.loaded.end(), from, end);
    }
    from = end;
  });
  result.used_bytes = static_cast<std::int64_t>(result.loaded.size()) + prepared_bytes(kind, frame);
  return result;
}

}  // namespace maquette::sim
