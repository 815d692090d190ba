#include "sim/trace/bus_record.hpp"

#include <algorithm>

namespace maquette::sim {

std::int64_t expected_bytes(const BusRecord& record, std::int64_t per_access, std::int64_t per_wait,
                            std::int64_t per_line) {
  std::int64_t bytes =
      record.video ? static_cast<std::int64_t>(record.video->lines.size()) * per_line : 0;
  for (const RecordedBus& bus : record.buses) {
    const auto waits =
        std::count_if(bus.accesses.begin(), bus.accesses.end(),
                      [](const RecordedAccess& access) { return access.request < access.grant; });
    bytes += static_cast<std::int64_t>(bus.accesses.size()) * per_access + waits * per_wait;
  }
  return bytes;
}

}  // namespace maquette::sim
