#include "tests/processor/random_instructions.hpp"

#include <algorithm>
#include <map>

namespace maquette::tests {

namespace {

using namespace models::mc68000;

constexpr unsigned k_longest_instruction = 5;  // words
constexpr unsigned k_attempts = 1000;

// What LINK A7 stores is the lowered stack pointer by Motorola's description, and the one before by
// other processors' authors; no compiler uses it.
constexpr std::uint16_t k_link_of_stack = 0x4e57;

bool is_decimal(unsigned word) {
  return (word & 0xb1f0U) == 0x8100 || (word & 0xffc0U) == 0x4800;  // ABCD, SBCD, NBCD
}

// What the manual leaves undefined: N and V of decimal arithmetic, N and Z of a division that
// overflows, all but X of CHK.
unsigned undefined_codes(unsigned word, unsigned codes) {
  const bool division = (word & 0xf0c0U) == 0x80c0;
  const bool bounds = (word & 0xf1c0U) == 0x4180;
  return (is_decimal(word) ? 10U : 0U) | (division && (codes & 2U) != 0 ? 12U : 0U) |
         (bounds ? 15U : 0U);
}

}  // namespace

std::uint8_t* TrialMemory::place_of(std::uint32_t address, bool to_write) {
  const std::uint32_t in_data = address - data_begin_;
  if (in_data < data_.size()) return &data_[in_data];
  const std::uint32_t in_program = address - program_begin;
  return in_program < program.size() && !to_write ? &program[in_program] : nullptr;
}

BusReply TrialMemory::access(const BusRequest& request, const Account& /*account*/) {
  BusReply reply;
  if (request.kind == BusRequest::Kind::fetch) {
    const std::uint32_t word =
        (request.address - program_begin - static_cast<std::uint32_t>(program.size())) / 2;
    reply.error = word >= instruction.size();
    if (!reply.error) reply.value = instruction[word];
    fetched = std::max(fetched, word + 1);
    return reply;
  }
  const bool to_write = request.kind != BusRequest::Kind::read;
  const unsigned bytes = bytes_of(request.size);
  for (unsigned byte = 0; byte < bytes; ++byte) {
    std::uint8_t* place = place_of(request.address + byte, to_write);
    if (place == nullptr) {
      reply.error = true;
      return reply;
    }
    reply.value = reply.value << 8U | *place;
    if (request.kind == BusRequest::Kind::write) {
      *place = static_cast<std::uint8_t>(request.value >> 8U * (bytes - 1 - byte));
    }
    if (request.kind == BusRequest::Kind::test_and_set) *place |= 0x80U;
  }
  return reply;
}

// Words that are likely to make a displacement, an index word with D7, the address of data or of
// what follows, or a mask.
std::uint16_t InstructionTrial::likely_word() {
  const std::uint32_t target = below(2) == 0 ? memory_->data_begin() : here() + 6;
  switch (below(6)) {
    case 0:
      return static_cast<std::uint16_t>(2 * below(64) - 64);
    case 1:
      return static_cast<std::uint16_t>(0x7000U | below(2) << 11U | below(256));
    case 2:
      return static_cast<std::uint16_t>(target >> 16U);
    case 3:
      return static_cast<std::uint16_t>(target + 2 * below(4) - 2);
    case 4:
      return 2;
    default:
      return static_cast<std::uint16_t>(random_());
  }
}

// No address has more than 24 bits: not every processor drops the others.
std::uint16_t InstructionTrial::extension_word() {
  const std::uint16_t word = likely_word();
  const std::uint16_t low = word & 0xffU;
  return low < 0x10 ? low : word;
}

TriedInstruction InstructionTrial::draw(const std::vector<std::uint16_t>& words) {
  TriedInstruction tried{};
  tried.words.push_back(words[below(static_cast<std::uint32_t>(words.size()))]);
  while (tried.words.size() < k_longest_instruction) tried.words.push_back(extension_word());
  // qemu takes an immediate bit number of more than eight bits for an illegal instruction.
  if (tried.words[0] >> 8U == 0x08) tried.words[1] &= 0xffU;
  const auto size = static_cast<std::uint32_t>(memory_->data().size());
  for (unsigned number = 0; number < 16; ++number) {
    const auto any = static_cast<std::uint32_t>(random_());
    const std::uint32_t address =
        memory_->data_begin() + (size == 0 ? 0 : size / 4 + 2 * below(size / 4));
    tried.registers[number] = number < 8 ? any >> below(32) : address + (below(16) == 0 ? 1 : 0);
    if (number >= 8 && below(16) == 0) tried.registers[number] = here() + 2;
  }
  for (unsigned number = 0; number < 8 && is_decimal(tried.words[0]); ++number) {
    tried.registers[number] = below(10) << 4U | below(10);
  }
  if (!is_decimal(tried.words[0])) tried.registers[7] = 2 * below(128) - 128;
  tried.codes = below(32);
  return tried;
}

bool InstructionTrial::execute(TriedInstruction& tried) {
  Mc68000 processor({nullptr, 0}, *memory_);
  processor.registers().set_status(status_ | tried.codes);
  processor.registers().general = tried.registers;
  processor.registers().program_counter = here();
  memory_->instruction = tried.words;
  memory_->fetched = 0;
  if (processor.step().reason != StopReason::cycle_limit) return false;
  if (((processor.registers().status() ^ status_) & 0xff00U) != 0) return false;
  const std::uint32_t length = (processor.registers().program_counter - here()) / 2;
  if (length < memory_->fetched || length > k_longest_instruction) return false;
  tried.words.resize(length);
  tried.undefined_codes = undefined_codes(tried.words[0], processor.registers().conditions.bits());
  return true;
}

std::optional<TriedInstruction> InstructionTrial::find(const std::vector<std::uint16_t>& words) {
  const std::vector<std::uint8_t> before = memory_->data();
  for (unsigned attempt = 0; attempt < k_attempts; ++attempt) {
    TriedInstruction tried = draw(words);
    if (execute(tried)) return tried;
    memory_->restore(before);
  }
  return std::nullopt;
}

std::vector<std::vector<std::uint16_t>> instruction_forms() {
  std::map<Handler, std::size_t> place_of;
  std::vector<std::vector<std::uint16_t>> forms;
  for (unsigned index = 0; index < 0x10000; ++index) {
    const auto word = static_cast<std::uint16_t>(index);
    if (!decoder_table().is_legal(word) || word == k_link_of_stack) continue;
    const auto [place, is_new] = place_of.emplace(decoder_table()[word].execute, forms.size());
    if (is_new) forms.emplace_back();
    forms[place->second].push_back(word);
  }
  return forms;
}

void append(std::vector<std::uint8_t>& program, const std::vector<std::uint16_t>& words) {
  for (const std::uint16_t word : words) {
    program.push_back(static_cast<std::uint8_t>(word >> 8U));
    program.push_back(static_cast<std::uint8_t>(word));
  }
}

void append_long(std::vector<std::uint8_t>& program, std::uint32_t value) {
  append(program, {static_cast<std::uint16_t>(value >> 16U), static_cast<std::uint16_t>(value)});
}

}  // namespace maquette::tests
