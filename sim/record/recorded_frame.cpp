#include "sim/record/recorded_frame.hpp"

#include <fmt/format.h>

#include "firmware_version.hpp"
#include "sim/database/database_image.hpp"
#include "sim/report/digest.hpp"

namespace maquette::sim {

std::string RecordKey::name() const {
  const std::string all = fmt::format("{} {} {} {} {}", scene_sha1, firmware, format.width,
                                      format.height, format.has_depth);
  return sha1_of(all.data(), all.size());
}

RecordKey record_key_of(const firmware::Database<float>& database) {
  const std::vector<unsigned char> image = database_image(database);
  return {sha1_of(image.data(), image.size()),
          firmware::k_firmware_version,
          {database.observer.columns, database.observer.rows, database.needs.depth}};
}

}  // namespace maquette::sim
