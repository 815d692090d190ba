#include "sim/picture/animated_png.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace maquette::sim {
namespace {

constexpr std::size_t k_signature_bytes = 8;
constexpr std::size_t k_field_bytes = 4;
constexpr std::size_t k_size_bytes = 8;  // width and height, which begin the header

struct Chunk {
  std::string_view type;
  std::string_view data;
};

std::string big_endian(std::uint32_t value, int bytes = 4) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) {
    text += static_cast<char>(value >> (8 * i));
  }
  return text;
}

/// The remainders of all bytes by the polynomial of CRC-32.
constexpr std::array<std::uint32_t, 256> k_remainders = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1U) != 0 ? 0xEDB88320U ^ (value >> 1U) : value >> 1U;
    }
    table[byte] = value;
  }
  return table;
}();

std::uint32_t check_sum(std::string_view bytes) {
  std::uint32_t value = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    value = k_remainders[(value ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (value >> 8U);
  }
  return ~value;
}

std::uint32_t number_at(std::string_view file, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < k_field_bytes; ++i) {
    value = (value << 8U) | static_cast<unsigned char>(file.at(at + i));
  }
  return value;
}

std::vector<Chunk> chunks_of(std::string_view file) {
  std::vector<Chunk> chunks;
  std::size_t at = k_signature_bytes;
  while (at + 3 * k_field_bytes <= file.size()) {
    const std::size_t length = number_at(file, at);
    chunks.push_back({file.substr(at + k_field_bytes, k_field_bytes),
                      file.substr(at + 2 * k_field_bytes, length)});
    at += 3 * k_field_bytes + length;
  }
  return chunks;
}

/// How long a picture that covers the whole is shown.
std::string frame_control(std::uint32_t sequence, std::string_view size, double pictures_per_s) {
  constexpr double k_milliseconds_per_s = 1000;
  const auto shown = static_cast<std::uint32_t>(std::lround(k_milliseconds_per_s / pictures_per_s));
  const std::string place(k_size_bytes, '\0');
  const std::string whole_replaces(2, '\0');
  return big_endian(sequence) + std::string(size) + place + big_endian(shown, 2) +
         big_endian(static_cast<std::uint32_t>(k_milliseconds_per_s), 2) + whole_replaces;
}

}  // namespace

std::string png_chunk(std::string_view type, std::string_view data) {
  const std::string checked = std::string(type) + std::string(data);
  return big_endian(static_cast<std::uint32_t>(data.size())) + checked +
         big_endian(check_sum(checked));
}

std::string animated_png(const std::vector<std::string>& pictures, double pictures_per_s) {
  if (pictures.empty()) {
    throw std::runtime_error("a film without pictures");
  }
  const std::string_view header = chunks_of(pictures.front()).at(0).data;
  std::string file = pictures.front().substr(0, k_signature_bytes) + png_chunk("IHDR", header);
  const std::string begins_again = big_endian(0);
  file += png_chunk("acTL", big_endian(static_cast<std::uint32_t>(pictures.size())) + begins_again);
  std::uint32_t sequence = 0;
  for (const std::string& picture : pictures) {
    const std::vector<Chunk> chunks = chunks_of(picture);
    if (chunks.at(0).data != header) {
      throw std::runtime_error("pictures of a film differ in size or format");
    }
    file += png_chunk("fcTL",
                      frame_control(sequence++, header.substr(0, k_size_bytes), pictures_per_s));
    for (const Chunk& chunk : chunks) {
      if (chunk.type == "IDAT") {
        file += &picture == &pictures.front()
                    ? png_chunk("IDAT", chunk.data)
                    : png_chunk("fdAT", big_endian(sequence++) + std::string(chunk.data));
      }
    }
  }
  return file + png_chunk("IEND", "");
}

}  // namespace maquette::sim
