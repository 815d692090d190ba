#include "sim/report/digest.hpp"

#include <array>
#include <cstdint>
#include <cstring>

namespace maquette::sim {

namespace {

constexpr std::size_t k_block_bytes = 64;
constexpr std::size_t k_length_bytes = 8;
constexpr unsigned k_word_bits = 32;

using State = std::array<std::uint32_t, 5>;

std::uint32_t turned(std::uint32_t word, unsigned bits) {
  return word << bits | word >> (k_word_bits - bits);
}

std::uint32_t choice(std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return (b & (c ^ d)) ^ d;
}

std::uint32_t parity(std::uint32_t b, std::uint32_t c, std::uint32_t d) { return b ^ c ^ d; }

std::uint32_t majority(std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return (b & c) | (d & (b | c));
}

/// Twenty rounds of one function and constant (FIPS 180-4, sections 4.1.1 and 4.2.1).
template <std::uint32_t (*function)(std::uint32_t b, std::uint32_t c, std::uint32_t d)>
void turn(const std::uint32_t* words, std::uint32_t constant, State& state) {
  auto [a, b, c, d, e] = state;
  for (int round = 0; round < 20; ++round) {
    const std::uint32_t next = turned(a, 5) + function(b, c, d) + e + constant + words[round];
    e = d;
    d = c;
    c = turned(b, 30);
    b = a;
    a = next;
  }
  state = {a, b, c, d, e};
}

void take_block(const unsigned char* block, State& state) {
  constexpr std::size_t k_rounds = 80;
  std::array<std::uint32_t, k_rounds> words{};
  for (std::size_t i = 0; i < k_block_bytes / 4; ++i, block += 4) {
    words[i] = std::uint32_t{block[0]} << 24 | std::uint32_t{block[1]} << 16 |
               std::uint32_t{block[2]} << 8 | block[3];
  }
  for (std::size_t i = 16; i < k_rounds; ++i) {
    words[i] = turned(words[i - 3] ^ words[i - 8] ^ words[i - 14] ^ words[i - 16], 1);
  }
  State now = state;
  turn<choice>(words.data(), 0x5a827999, now);
  turn<parity>(&words[20], 0x6ed9eba1, now);
  turn<majority>(&words[40], 0x8f1bbcdc, now);
  turn<parity>(&words[60], 0xca62c1d6, now);
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i] += now[i];
  }
}

/// What follows the last whole block: a bit, and the length in bits in the last eight bytes.
void take_end(const unsigned char* rest, std::size_t rest_bytes, std::size_t count, State& state) {
  std::array<unsigned char, 2 * k_block_bytes> end{};
  std::memcpy(end.data(), rest, rest_bytes);
  end[rest_bytes] = 0x80;
  const std::size_t bytes =
      rest_bytes + 1 + k_length_bytes <= k_block_bytes ? k_block_bytes : 2 * k_block_bytes;
  std::uint64_t bits = std::uint64_t{count} * 8;
  for (std::size_t i = 1; i <= k_length_bytes; ++i) {
    end[bytes - i] = static_cast<unsigned char>(bits);
    bits >>= 8;
  }
  for (std::size_t at = 0; at < bytes; at += k_block_bytes) {
    take_block(end.data() + at, state);
  }
}

std::string digits_of(const State& state) {
  std::string text;
  for (const std::uint32_t word : state) {
    for (unsigned shift = k_word_bits; shift > 0; shift -= 4) {
      text += "0123456789abcdef"[word >> (shift - 4) & 0xF];
    }
  }
  return text;
}

}  // namespace

std::string sha1_of(const void* bytes, std::size_t count) {
  State state{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476, 0xc3d2e1f0};
  const auto* next = static_cast<const unsigned char*>(bytes);
  std::size_t left = count;
  for (; left >= k_block_bytes; left -= k_block_bytes, next += k_block_bytes) {
    take_block(next, state);
  }
  static constexpr unsigned char k_none = 0;
  take_end(left == 0 ? &k_none : next, left, count, state);
  return digits_of(state);
}

}  // namespace maquette::sim
