#include "models/board/instruction_processor.hpp"

#include <algorithm>
#include <ios>
#include <sstream>
#include <systemc>

namespace maquette::models {

namespace {

using mc68000::BusRequest;
using mc68000::OperandSize;

constexpr unsigned k_byte_bits = 8;
constexpr unsigned char k_taken = 0x80;

unsigned bytes_of(const BusRequest& request, unsigned word_bytes) {
  return request.size == OperandSize::byte ? word_bytes : mc68000::bytes_of(request.size);
}

mc68000::Account with(mc68000::Account account, const mc68000::InstructionCost& cost) {
  account.add(cost);
  return account;
}

/// Bytes on the bus: a byte goes with the whole word that it lies in.
void put_bytes(const BusRequest& request, unsigned word_bytes, std::vector<unsigned char>& bytes) {
  const unsigned count = mc68000::bytes_of(request.size);
  bytes.assign(bytes_of(request, word_bytes), 0);
  for (unsigned byte = 0; byte < count; ++byte) {
    bytes[byte] = static_cast<unsigned char>(request.value >> k_byte_bits * (count - 1 - byte));
  }
}

std::uint32_t value_of(const BusRequest& request, const std::vector<unsigned char>& bytes) {
  std::uint32_t value = 0;
  for (unsigned byte = 0; byte < mc68000::bytes_of(request.size); ++byte) {
    value = value << k_byte_bits | bytes[byte];
  }
  return value;
}

void require_end(const mc68000::Stop& stop) {
  if (stop.reason != mc68000::StopReason::stop_instruction) {
    std::ostringstream message;
    message << "the program of the board stops at 0x" << std::hex << stop.instruction_address
            << ", word 0x" << stop.instruction_word << ", access to 0x" << stop.access_address
            << ": " << mc68000::name_of(stop.reason);
    SC_REPORT_ERROR("/maquette/kvm02", message.str().c_str());
  }
}

}  // namespace

InstructionProcessor::InstructionProcessor(const Kvm02Parameters& parameters, const VersaBus& bus,
                                           const SharedWindow& shared, Processor& processor,
                                           Observer written)
    : time_(parameters),
      shared_(shared),
      word_bytes_(bus.word_bytes()),
      processor_(processor),
      watch_(bus, processor, shared.next_unit()),
      written_(std::move(written)) {
  test_and_set_.transaction.test_and_set = true;
  test_and_set_.transaction.modify = processor.clock().times(mc68000::k_modify_cycles);
}

void InstructionProcessor::run(BoardProgram& program) {
  while (true) {
    const ProgramEvent event = program.next();
    spend(event);
    switch (event.kind) {
      case ProgramEvent::Kind::access:
        access(event, program);
        break;
      case ProgramEvent::Kind::synthesis:
        preprocessing_ = spent_;
        before_pixels_ = processor_.spent();
        break;
      case ProgramEvent::Kind::end:
        require_end(event.stop);
        return;
    }
  }
}

// Only fetches off the board, which fall at the start of their instruction, are behind what is
// spent: they follow at once.
void InstructionProcessor::spend(const ProgramEvent& event) {
  const mc68000::Account account = with(event.account, event.request.before);
  const Duration elapsed = std::max(time_.elapsed(account, event.work), spent_);
  processor_.compute(elapsed - spent_);
  spent_ = elapsed;
}

void InstructionProcessor::access(const ProgramEvent& event, BoardProgram& program) {
  const BusRequest& request = event.request;
  switch (request.kind) {
    case BusRequest::Kind::fetch:
    case BusRequest::Kind::read:
      program.answer(read(request));
      break;
    case BusRequest::Kind::test_and_set:
      program.answer(test_and_set(request));
      break;
    case BusRequest::Kind::write:
      if (request.address >= kept_.base && request.address < kept_.end) {
        keep(event);
      } else {
        write(request);
      }
      break;
  }
}

void InstructionProcessor::keep(const ProgramEvent& event) {
  const bool is_first = event.request.address % FrameMemory::k_pixel_bytes == 0;
  time_.add(is_first ? kept_.clocks.first_word : kept_.clocks.second_word);
  ProgramEvent again = event;
  again.work = {};
  spend(again);
  processor_.pass();
  written_(event.request.address, event.request.value);
}

std::uint32_t InstructionProcessor::read(const BusRequest& request) {
  read_.bytes.resize(bytes_of(request, word_bytes_));
  read_.aim(request.address);
  processor_.transact(read_);
  database_words_ += request.address >= shared_.database() ? 1 : 0;
  return value_of(request, read_.bytes);
}

void InstructionProcessor::write(const BusRequest& request) {
  put_bytes(request, word_bytes_, write_.bytes);
  write_.aim(request.address);
  processor_.transact(write_);
  written_(request.address, request.value);
}

std::uint32_t InstructionProcessor::test_and_set(const BusRequest& request) {
  test_and_set_.bytes.resize(word_bytes_);
  test_and_set_.aim(request.address);
  processor_.transact(test_and_set_);
  const std::uint32_t value = value_of(request, test_and_set_.bytes);
  if ((value & k_taken) == 0) {
    ++locks_taken_;
    watch_.count_success();
  } else {
    ++failed_tries_;
    watch_.count_failure();
  }
  return value;
}

}  // namespace maquette::models
