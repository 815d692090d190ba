#pragma once

#include <tlm_utils/simple_target_socket.h>
#include <cstdint>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/board/shared_memory_parameters.hpp"

namespace maquette::models {

/// What boards share, by bus address.
struct SharedWindow {
  static constexpr std::uint64_t k_lock_offset = 0;
  static constexpr std::uint64_t k_next_unit_offset = 4;
  static constexpr std::uint64_t k_header_bytes = 8;
  static constexpr unsigned char k_taken = 0x80;  ///< bit of the lock's byte

  std::uint64_t base = 0;
  std::int64_t database_bytes = 0;  ///< behind the header; zero when boards have copies

  /// Of the counter's lock: free while the top bit of its first byte is clear.
  [[nodiscard]] std::uint64_t lock() const { return base + k_lock_offset; }

  /// Of the number of the first unit that nobody has claimed, 32 bits.
  [[nodiscard]] std::uint64_t next_unit() const { return base + k_next_unit_offset; }

  /// Of the database's first byte.
  [[nodiscard]] std::uint64_t database() const { return base + k_header_bytes; }
};

/// A memory board on the bus, such as the M68KVM10 and 11 (VM02 data sheet p. 2-65). Assumption:
/// its ports do not delay one another.
class SharedMemory : public sc_core::sc_module {
 public:
  /// `size_bytes` of zeros with a port for each of `ports` backplanes. Throws std::invalid_argument
  /// for a negative access time.
  SharedMemory(const sc_core::sc_module_name& name, const SharedMemoryParameters& parameters,
               std::size_t size_bytes, int ports);

  sc_core::sc_vector<tlm_utils::simple_target_socket<SharedMemory>> bus_ports;

  [[nodiscard]] std::uint64_t size_bytes() const { return cells_.size(); }

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(tlm::tlm_generic_payload& payload);

  sc_core::sc_time access_time_;
  std::vector<unsigned char> cells_;
};

}  // namespace maquette::models
