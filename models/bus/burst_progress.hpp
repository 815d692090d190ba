#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tlm>

#include "models/bus/bus_transaction.hpp"

namespace maquette::models {

/// The burst that a master has on the bus, access by access; used again for its next burst.
class BurstProgress {
 public:
  explicit BurstProgress(unsigned word_bytes);
  BurstProgress(const BurstProgress&) = delete;
  BurstProgress& operator=(const BurstProgress&) = delete;
  BurstProgress(BurstProgress&&) = delete;
  BurstProgress& operator=(BurstProgress&&) = delete;
  ~BurstProgress() = default;

  /// A burst begins, which is kept by reference until its end. Reports misuse, in the name of its
  /// master, of a burst that is not a whole number of bus words, each with an address.
  void begin(tlm::tlm_generic_payload& burst, const std::string& master);

  /// The access that is next has ended.
  void pass_access() { ++transaction_->accesses; }

  /// Whether an access of the burst has ended.
  [[nodiscard]] bool has_begun() const { return transaction_->accesses > 0; }

  /// How many there are from the access that is next on, where they are writes with the same gap
  /// before each.
  [[nodiscard]] std::int64_t alike() const;

  [[nodiscard]] tlm::tlm_generic_payload& burst() { return *burst_; }
  [[nodiscard]] BusTransaction& transaction() { return *transaction_; }
  [[nodiscard]] const BusTransaction& transaction() const { return *transaction_; }

  /// Of the access that is next: its address, its bytes, and these as the 68000 has them, the first
  /// in the highest place.
  [[nodiscard]] std::uint64_t address() const;
  [[nodiscard]] unsigned char* bytes() const {
    return burst_->get_data_ptr() + static_cast<std::size_t>(transaction_->accesses) * word_bytes_;
  }
  [[nodiscard]] std::uint32_t word() const;
  [[nodiscard]] unsigned word_bytes() const { return word_bytes_; }

  /// Whether there is no access any more.
  [[nodiscard]] bool has_ended() const { return transaction_->accesses == accesses_; }

  /// Whether others come after the access that is next.
  [[nodiscard]] bool has_more() const { return transaction_->accesses + 1 < accesses_; }

  /// The bytes of the access that is so many after the next one, and its address.
  [[nodiscard]] unsigned char* bytes_after(std::int64_t accesses) const {
    return bytes() + static_cast<std::size_t>(accesses) * word_bytes_;
  }
  [[nodiscard]] std::uint64_t address_after(std::int64_t accesses) const;

  /// Those from the access that is next on, where they do not follow one another.
  [[nodiscard]] const std::uint64_t* addresses() const {
    return transaction_->addresses.data() + transaction_->accesses;
  }

  /// Whether the addresses of the accesses follow one another.
  [[nodiscard]] bool is_consecutive() const { return transaction_->addresses.empty(); }

  /// The payload in which a slave sees the access that is next, with the instant of its strobe.
  tlm::tlm_generic_payload& access_of_slave(std::uint64_t offset, Instant strobe);

 private:
  unsigned word_bytes_;
  tlm::tlm_generic_payload* burst_ = nullptr;
  BusTransaction* transaction_ = nullptr;
  BusTransaction plain_;       // stands in for a payload's missing extension
  std::int64_t accesses_ = 0;  // of the burst
  BusStrobe strobe_;           // before the payload, which frees its extensions
  tlm::tlm_generic_payload access_;
};

}  // namespace maquette::models
