#pragma once

#include <cstdint>
#include <tlm>
#include <vector>

#include "models/bus/bus_transaction.hpp"

namespace maquette::models {

/// A burst of a master with all that it refers to, to be used again and again.
struct BusBurst {
  BusTransaction transaction;  // before the payload, which frees its extensions
  tlm::tlm_generic_payload payload;
  std::vector<unsigned char> bytes;

  explicit BusBurst(tlm::tlm_command command) {
    payload.set_extension(&transaction);
    payload.set_command(command);
  }
  BusBurst(const BusBurst&) = delete;
  BusBurst& operator=(const BusBurst&) = delete;
  BusBurst(BusBurst&&) = delete;
  BusBurst& operator=(BusBurst&&) = delete;
  ~BusBurst() = default;

  /// Points the payload to the bytes; `address` is that of the first access.
  void aim(std::uint64_t address) {
    const auto length = static_cast<unsigned>(bytes.size());
    payload.set_address(address);
    payload.set_data_ptr(bytes.data());
    payload.set_data_length(length);
    payload.set_streaming_width(length);
  }
};

}  // namespace maquette::models
