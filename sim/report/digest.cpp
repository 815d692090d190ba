#include "sim/report/digest.hpp"

#include <OpenImageIO/hash.h>
#include <OpenImageIO/strutil.h>

namespace maquette::sim {

std::string sha1_of(const void* bytes, std::size_t count) {
  return OIIO::Strutil::lower(OIIO::SHA1::digest(bytes, count));
}

}  // namespace maquette::sim
