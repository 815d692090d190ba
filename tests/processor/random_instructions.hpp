#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "models/board/mc68000/decoder_table.hpp"
#include "models/board/mc68000/mc68000.hpp"

/// Random instructions that another processor can execute as well: each was tried on the model
/// before.
namespace maquette::tests {

/// An instruction, and the state that it was tried in.
struct TriedInstruction {
  std::vector<std::uint16_t> words;
  std::array<std::uint32_t, 16> registers;
  unsigned codes;            // XNZVC before it
  unsigned undefined_codes;  // what the manual leaves undefined after it
};

/// Memory as an instruction on trial sees it: the program before it can be read, its data written.
class TrialMemory final : public models::mc68000::ExternalBus {
 public:
  TrialMemory(std::uint32_t data_begin, std::vector<std::uint8_t> data)
      : data_begin_(data_begin), data_(std::move(data)) {}

  models::mc68000::BusReply access(const models::mc68000::BusRequest& request,
                                   const models::mc68000::Account& account) override;

  std::uint32_t program_begin = 0;
  std::vector<std::uint8_t> program;       // what was accepted so far
  std::vector<std::uint16_t> instruction;  // what is tried behind it, and never read as data
  unsigned fetched = 0;                    // words of it
  [[nodiscard]] const std::vector<std::uint8_t>& data() const { return data_; }
  void restore(const std::vector<std::uint8_t>& data) { data_ = data; }
  [[nodiscard]] std::uint32_t data_begin() const { return data_begin_; }

 private:
  std::uint8_t* place_of(std::uint32_t address, bool to_write);

  std::uint32_t data_begin_;
  std::vector<std::uint8_t> data_;
};

/// Draws instructions until one can be executed without leaving its place.
class InstructionTrial {
 public:
  InstructionTrial(TrialMemory& memory, unsigned status, unsigned seed)
      : memory_(&memory), status_(status), random_(seed) {}

  /// An instruction among `words`, which are instruction words, to follow the memory's program; its
  /// effect on the data stays. Nothing when none was found in a thousand attempts.
  std::optional<TriedInstruction> find(const std::vector<std::uint16_t>& words);

 private:
  TriedInstruction draw(const std::vector<std::uint16_t>& words);
  std::uint16_t likely_word();
  std::uint16_t extension_word();
  bool execute(TriedInstruction& tried);
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  std::uint32_t here() const {
    return memory_->program_begin + static_cast<std::uint32_t>(memory_->program.size());
  }

  TrialMemory* memory_;
  unsigned status_;
  std::mt19937 random_;
};

/// The legal instruction words, by instruction, size and addressing modes; LINK A7 left out.
std::vector<std::vector<std::uint16_t>> instruction_forms();

/// Writes an instruction's words, or any others, to the end of a program.
void append(std::vector<std::uint8_t>& program, const std::vector<std::uint16_t>& words);

/// Writes a long word.
void append_long(std::vector<std::uint8_t>& program, std::uint32_t value);

}  // namespace maquette::tests
