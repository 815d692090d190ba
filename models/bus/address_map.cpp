#include "models/bus/address_map.hpp"

#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace maquette::models {

void AddressMap::add(const AddressRange& range) {
  if (range.size == 0) {
    throw std::invalid_argument("slave " + range.slave + " has no addresses");
  }
  for (const AddressRange& other : ranges_) {
    if (range.contains(other.base) || other.contains(range.base)) {
      throw std::invalid_argument("slave " + range.slave + " overlaps slave " + other.slave);
    }
  }
  ranges_.push_back(range);
}

int AddressMap::find(std::uint64_t address) const {
  for (std::size_t slave = 0; slave < ranges_.size(); ++slave) {
    if (ranges_[slave].contains(address)) {
      return static_cast<int>(slave);
    }
  }
  return k_unmapped;
}

std::string AddressMap::text() const {
  std::ostringstream text;
  text << std::hex << std::uppercase << std::setfill('0');
  for (const AddressRange& range : ranges_) {
    text << std::setw(8) << range.base << '-' << std::setw(8) << range.base + range.size - 1 << ' '
         << range.slave << '\n';
  }
  return text.str();
}

}  // namespace maquette::models
