#include "models/board/database_reader.hpp"

#include <algorithm>

#include "models/board/long_word.hpp"

namespace maquette::models {

DatabaseReader::DatabaseReader(std::int64_t cache_bytes, const SharedWindow& shared,
                               unsigned word_bytes, Processor& processor)
    : cache_(cache_bytes, shared.database_bytes),
      shared_(shared),
      word_bytes_(word_bytes),
      processor_(processor) {
  burst_.transaction.item_accesses = static_cast<std::int64_t>(k_long_bytes / word_bytes);
}

void DatabaseReader::compute(const firmware::Work& work) {
  const std::int64_t loads = cache_.misses(work[firmware::Operation::load]);
  const Duration time = processor_.take_on(work, loads);
  if (loads == 0) {
    processor_.compute(time);
  } else {
    read(time, loads);
  }
}

// One burst for all loads, whose gaps the bus keeps: the time is cut into one part before each load
// and one after the last; the first parts are a tick longer where it does not divide.
void DatabaseReader::read(Duration computing, std::int64_t loads) {
  const Duration part = computing / (loads + 1);
  const std::int64_t longer = (computing % (loads + 1)).count();
  burst_.transaction.gap = part;
  burst_.transaction.longer_gaps = std::max<std::int64_t>(longer - 1, 0);
  set_addresses(loads);
  processor_.compute(part + (longer > 0 ? k_tick : Duration::zero()));
  processor_.transact(burst_);
  words_ += burst_.transaction.accesses;
  processor_.compute(part);
}

void DatabaseReader::set_addresses(std::int64_t loads) {
  std::vector<std::uint64_t>& addresses = burst_.transaction.addresses;
  addresses.clear();
  const auto end = static_cast<std::uint64_t>(shared_.database_bytes);
  for (std::int64_t load = 0; load < loads; ++load) {
    for (unsigned byte = 0; byte < k_long_bytes; byte += word_bytes_) {
      addresses.push_back(shared_.database() + offset_);
      offset_ += word_bytes_;
      offset_ = offset_ < end ? offset_ : 0;
    }
  }
  burst_.bytes.resize(addresses.size() * word_bytes_);
  burst_.aim(addresses.front());
}

}  // namespace maquette::models
