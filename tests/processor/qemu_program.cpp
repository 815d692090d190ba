// Writes a Linux program of random instructions, which logs the registers after each, and what the
// model of the MC68000 makes of it. Usage: qemu_program PROGRAM EXPECTED SEED

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/processor/random_instructions.hpp"

namespace {

using namespace maquette::tests;
using namespace maquette::models::mc68000;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t k_program = 0x1'0000;
constexpr std::uint32_t k_data = 0x8'0000;
constexpr std::uint32_t k_data_size = 0x4000;
constexpr std::uint32_t k_states = 0x9'0000;  // registers before each instruction
constexpr std::uint32_t k_log = 0xc'0000;     // condition codes and registers after each
constexpr std::uint32_t k_end = 0x10'0000;
constexpr std::uint32_t k_state_size = 64;
constexpr std::uint32_t k_log_size = 66;
constexpr unsigned k_rounds = 2;

void append_address(Bytes& program, std::vector<std::uint16_t> words, std::uint32_t address) {
  append(program, words);
  append_long(program, address);
}

// Loads registers and condition codes.
void append_setup(Bytes& program, unsigned index, unsigned codes) {
  append_address(program, {0x4cf9, 0xffff}, k_states + index * k_state_size);
  append(program, {0x44fc, static_cast<std::uint16_t>(codes)});
}

// Logs the condition codes that are defined, and the registers.
void append_log(Bytes& program, unsigned index, unsigned undefined_codes) {
  const std::uint32_t place = k_log + index * k_log_size;
  append_address(program, {0x40f9}, place);
  append_address(program, {0x48f9, 0xffff}, place + 2);
  append_address(program, {0x0279, static_cast<std::uint16_t>(0x1f & ~undefined_codes)}, place);
}

// write(1, address, size)
void append_write(Bytes& program, std::uint32_t address, std::uint32_t size) {
  append(program, {0x7004, 0x7201});
  append_address(program, {0x243c}, address);
  append_address(program, {0x263c}, size);
  append(program, {0x4e40});
}

// What qemu does otherwise than an MC68000, seen in its version 7.2: decimal digits beyond nine,
// which the manual leaves undefined and which memory may hold; bytes of ADDX and SUBX, which move
// A7 by one; LINK and UNLK of A7 itself; shifts in memory, where ASR loses the sign and LSR keeps
// it.
bool is_left_out(unsigned word) {
  const bool decimal_in_memory =
      (word & 0xb1f8U) == 0x8108 || ((word & 0xffc0U) == 0x4800 && (word & 0x38U) != 0);
  const bool byte_on_stack =
      ((word & 0xb1f8U) == 0x9108 && ((word & 7U) == 7 || (word >> 9U & 7U) == 7)) ||
      word == 0x4adf || word == 0x4ae7;
  const bool stack_as_frame = word == 0x4e5f;
  const bool shift_in_memory = (word & 0xfcc0U) == 0xe0c0;
  return decimal_in_memory || byte_on_stack || stack_as_frame || shift_in_memory;
}

std::vector<std::vector<std::uint16_t>> comparable_forms() {
  std::vector<std::vector<std::uint16_t>> forms;
  for (auto words : instruction_forms()) {
    words.erase(std::remove_if(words.begin(), words.end(), is_left_out), words.end());
    if (!words.empty()) forms.push_back(std::move(words));
  }
  return forms;
}

struct Image {
  Bytes memory;  // from k_program to k_end
  std::uint32_t log_size = 0;
};

void place(Image& image, std::uint32_t address, const Bytes& bytes) {
  std::copy(bytes.begin(), bytes.end(),
            image.memory.begin() + static_cast<std::ptrdiff_t>(address - k_program));
}

Bytes random_data() {
  std::mt19937 random(68'000);
  Bytes data(k_data_size);
  for (auto& byte : data) byte = static_cast<std::uint8_t>(random());
  return data;
}

// Appends instructions, each with its log, and returns the registers before each.
Bytes append_instructions(TrialMemory& memory, InstructionTrial& trial, unsigned& index) {
  Bytes states;
  for (unsigned round = 0; round < k_rounds; ++round) {
    for (const auto& form : comparable_forms()) {
      const Bytes before = memory.program;
      // The setup has the same length whatever the condition codes.
      append_setup(memory.program, index, 0);
      const auto tried = trial.find(form);
      memory.program = before;
      if (!tried) continue;
      append_setup(memory.program, index, tried->codes);
      append(memory.program, tried->words);
      append_log(memory.program, index, tried->undefined_codes);
      for (const std::uint32_t whole : tried->registers) append_long(states, whole);
      ++index;
    }
  }
  return states;
}

Image make_image(unsigned seed) {
  const Bytes data = random_data();
  TrialMemory memory(k_data, data);
  memory.program_begin = k_program;
  InstructionTrial trial(memory, 0, seed);
  unsigned index = 0;
  const Bytes states = append_instructions(memory, trial, index);
  Image image{Bytes(k_end - k_program), index * k_log_size};
  append_write(memory.program, k_log, image.log_size);
  append_write(memory.program, k_data, k_data_size);
  append(memory.program, {0x7001, 0x7200, 0x4e40});  // exit(0)
  place(image, k_program, memory.program);
  place(image, k_data, data);
  place(image, k_states, states);
  std::cout << index << " instructions\n";
  return image;
}

// An executable of one segment, as System V's interface for the 68000 has it.
Bytes executable(const Image& image) {
  constexpr std::uint32_t header_size = 52 + 32;
  const auto size = static_cast<std::uint32_t>(image.memory.size());
  Bytes file{0x7f, 'E', 'L', 'F', 1, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  append(file, {2, 4});  // an executable of a 68000
  for (const std::uint32_t value : {1U, k_program, 52U, 0U, 0U}) append_long(file, value);
  append(file, {52, 32, 1, 40, 0, 0});
  for (const std::uint32_t value : {1U, 0x1000U, k_program, k_program, size, size, 7U, 0x1000U}) {
    append_long(file, value);
  }
  file.resize(0x1000);
  static_assert(header_size <= 0x1000);
  file.insert(file.end(), image.memory.begin(), image.memory.end());
  return file;
}

// What the model leaves in log and data when the program comes to its first system call.
Bytes expected(const Image& image) {
  Bytes ram(k_end);
  std::copy(image.memory.begin(), image.memory.end(), ram.begin() + k_program);
  NoExternalBus bus;
  Mc68000 processor({ram.data(), k_end}, bus);
  processor.registers().set_status(0);
  processor.registers().program_counter = k_program;
  const Stop stop = processor.run({});
  if (stop.reason != StopReason::trap) {
    std::cerr << "the program stopped at " << std::hex << stop.instruction_address << ": "
              << name_of(stop.reason) << '\n';
    std::exit(1);
  }
  Bytes result(ram.begin() + k_log, ram.begin() + k_log + image.log_size);
  result.insert(result.end(), ram.begin() + k_data, ram.begin() + k_data + k_data_size);
  return result;
}

void write_file(const std::string& name, const Bytes& bytes) {
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const Image image = make_image(static_cast<unsigned>(std::stoul(arguments[3])));
  write_file(arguments[1], executable(image));
  write_file(arguments[2], expected(image));
}
