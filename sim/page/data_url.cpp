#include "sim/page/data_url.hpp"

#include <cstdint>

namespace maquette::sim {

namespace {

/// Six bits of each three bytes a letter; letters of which no byte is are padded (RFC 4648).
void append_base64(std::string_view bytes, std::string& text) {
  constexpr std::string_view k_letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::string_view three = bytes.substr(at, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      bits = bits << 8 | (i < three.size() ? static_cast<std::uint8_t>(three[i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= three.size() ? k_letters[bits >> (18 - 6 * i) & 0x3F] : '=';
    }
  }
}

}  // namespace

std::string data_url(std::string_view media_type, std::string_view bytes) {
  std::string url = "data:";
  url += media_type;
  url += ";base64,";
  append_base64(bytes, url);
  return url;
}

}  // namespace maquette::sim
