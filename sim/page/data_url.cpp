#include "sim/page/data_url.hpp"

#include <OpenImageIO/strutil.h>

namespace maquette::sim {

std::string data_url(std::string_view media_type, std::string_view bytes) {
  std::string url = "data:";
  url += media_type;
  url += ";base64,";
  url += OIIO::Strutil::base64_encode({bytes.data(), bytes.size()});
  return url;
}

}  // namespace maquette::sim
