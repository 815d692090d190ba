#pragma once

#include <cstdint>

#include "models/board/long_word.hpp"
#include "models/bus/bus_burst.hpp"

namespace maquette::models {

/// What is written into a mailbox: a long word that says which pixel it is about, and as many
/// numbers as are handed over, each a long word (floating point in 32 bits, or an index).
///
/// Assumption: a mailbox is a register of one long word with memory behind it, so all words go to
/// its address. The numbers themselves are not told, only that they are there.
class Message {
 public:
  static constexpr std::uint32_t k_header_longs = 1;

  explicit Message(unsigned word_bytes) : word_bytes_(word_bytes) {}

  /// Makes the burst one of so many numbers about a pixel.
  void address(std::uint64_t mailbox, std::uint32_t pixel, std::uint32_t numbers) {
    std::vector<unsigned char>& bytes = burst_.bytes;
    bytes.clear();
    append_long(pixel, bytes);
    bytes.resize(k_long_bytes * (k_header_longs + numbers));
    std::vector<std::uint64_t>& addresses = burst_.transaction.addresses;
    addresses.resize(bytes.size() / word_bytes_);
    for (std::size_t word = 0; word < addresses.size(); ++word) {
      addresses[word] = mailbox + word * word_bytes_ % k_long_bytes;
    }
    burst_.aim(mailbox);
  }

  [[nodiscard]] BusBurst& burst() { return burst_; }

 private:
  unsigned word_bytes_;
  BusBurst burst_{tlm::TLM_WRITE_COMMAND};
};

}  // namespace maquette::models
