#include "models/bus/burst_progress.hpp"

#include "models/bus/bus_misuse.hpp"
#include "models/bus/bus_word.hpp"

namespace maquette::models {

BurstProgress::BurstProgress(unsigned word_bytes) : word_bytes_(word_bytes) {
  access_.set_extension(&strobe_);
  access_.set_data_length(word_bytes);
  access_.set_streaming_width(word_bytes);
}

void BurstProgress::begin(tlm::tlm_generic_payload& burst, const std::string& master) {
  if (burst.get_data_length() == 0 || burst.get_data_length() % word_bytes_ != 0) {
    report_misuse("a burst of " + master + " is not a whole number of bus words");
  }
  auto* transaction = burst.get_extension<BusTransaction>();
  transaction_ = transaction != nullptr ? transaction : &plain_;
  burst_ = &burst;
  accesses_ = static_cast<std::int64_t>(burst.get_data_length() / word_bytes_);
  transaction_->accesses = 0;
  transaction_->waited = transaction_->transferred = Duration::zero();
  transaction_->longest_wait = Duration::zero();
  if (const auto given = static_cast<std::int64_t>(transaction_->addresses.size());
      given != 0 && given != accesses_) {
    report_misuse("a burst of " + master + " needs one address per access");
  }
  burst.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
}

std::int64_t BurstProgress::alike() const {
  const bool has_equal_gaps =
      transaction_->item_accesses == 1 && transaction_->longer_gaps <= transaction_->accesses;
  return burst_->is_write() && has_equal_gaps ? accesses_ - transaction_->accesses : 0;
}

std::uint64_t BurstProgress::address() const { return address_after(0); }

std::uint64_t BurstProgress::address_after(std::int64_t accesses) const {
  const auto index = static_cast<std::uint64_t>(transaction_->accesses + accesses);
  return transaction_->addresses.empty() ? burst_->get_address() + index * word_bytes_
                                         : transaction_->addresses[index];
}

std::uint32_t BurstProgress::word() const { return word_of(bytes(), word_bytes_); }

tlm::tlm_generic_payload& BurstProgress::access_of_slave(std::uint64_t offset, Instant strobe) {
  access_.set_address(offset);
  access_.set_data_ptr(bytes());
  access_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  strobe_.instant = strobe;
  return access_;
}

}  // namespace maquette::models
