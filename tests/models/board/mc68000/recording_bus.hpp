#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "models/board/mc68000/external_bus.hpp"

namespace maquette::tests {

/// A memory of bytes behind the bus that remembers what was asked of it.
class RecordingBus final : public models::mc68000::ExternalBus {
 public:
  using Kind = models::mc68000::BusRequest::Kind;

  models::mc68000::BusReply access(const models::mc68000::BusRequest& request,
                                   const models::mc68000::Account& account) override {
    requests.push_back(request);
    cycles.push_back(account.cycles);
    models::mc68000::BusReply answer = reply;
    const unsigned bytes = models::mc68000::bytes_of(request.size);
    for (unsigned byte = 0; byte < bytes; ++byte) {
      const std::uint32_t address = (request.address + byte) & 0xff'ffffU;
      answer.value = answer.value << 8U | memory[address];
      if (request.kind == Kind::write) {
        memory[address] = static_cast<std::uint8_t>(request.value >> 8U * (bytes - 1 - byte));
      }
      if (request.kind == Kind::test_and_set) memory[address] |= 0x80U;
    }
    return answer;
  }

  std::map<std::uint32_t, std::uint8_t> memory;
  std::vector<models::mc68000::BusRequest> requests;
  std::vector<std::uint64_t> cycles;  // at which they came
  models::mc68000::BusReply reply;    // but for its value
};

}  // namespace maquette::tests
