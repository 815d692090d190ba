#include "sim/report/digest.hpp"

#include <sha1.h>

#include <cstdint>

namespace maquette::sim {

std::string sha1_of(const void* bytes, std::size_t count) {
  char digits[SHA1_DIGEST_STRING_LENGTH];
  SHA1Data(static_cast<const std::uint8_t*>(bytes), count, digits);
  return digits;
}

}  // namespace maquette::sim
