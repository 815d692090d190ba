// Writes a ROM for an Atari ST without an operating system: random instructions, in registers and
// ROM only or in RAM as well. Prints the addresses between which time is to be taken, and the
// cycles, the accesses of data and the RAM that the model of the MC68000 comes to. Usage:
// hatari_program ROM EXPECTED_RAM registers|memory SEED

#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/processor/random_instructions.hpp"

namespace {

using namespace maquette::tests;
using namespace maquette::models::mc68000;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t k_rom = 0xfc'0000;
constexpr std::uint32_t k_rom_size = 192 * 1024;
constexpr std::uint32_t k_program = k_rom + 0x30;
constexpr std::uint32_t k_rom_data = k_rom + 0x1'2000;  // what the RAM begins with
constexpr std::uint32_t k_states = k_rom + 0x1'3000;    // registers before each instruction
constexpr std::uint32_t k_data = 0x1'0000;
constexpr std::uint32_t k_data_size = 0x1000;
constexpr std::uint32_t k_state_size = 64;
// MOVEM reads a word beyond its registers, which is still to be in the ROM.
constexpr std::uint32_t k_most_states = (k_rom_size - (k_states - k_rom)) / k_state_size - 1;

struct Image {
  Bytes rom;
  std::uint32_t begin = 0;  // of what is timed
  std::uint32_t end = 0;
};

void append_address(Bytes& program, const std::vector<std::uint16_t>& words,
                    std::uint32_t address) {
  append(program, words);
  append_long(program, address);
}

// No interrupts, the memory's size for the machine's chips, and the data of the RAM.
Bytes start() {
  Bytes program;
  append(program, {0x46fc, 0x2700, 0x13fc, 0x0005, 0xffff, 0x8001});
  append_address(program, {0x41f9}, k_rom_data);
  append_address(program, {0x43f9}, k_data);
  append(program, {0x303c, k_data_size / 4 - 1, 0x22d8, 0x51c8, 0xfffc});
  return program;
}

void append_setup(Bytes& program, unsigned index, unsigned codes) {
  append_address(program, {0x4cf9, 0xffff}, k_states + index * k_state_size);
  append(program, {0x44fc, static_cast<std::uint16_t>(codes)});
}

void place(Bytes& rom, std::uint32_t address, const Bytes& bytes) {
  std::copy(bytes.begin(), bytes.end(), rom.begin() + static_cast<std::ptrdiff_t>(address - k_rom));
}

// Appends instructions to the program, and returns the registers before each.
Bytes append_instructions(TrialMemory& memory, InstructionTrial& trial, unsigned rounds) {
  Bytes states;
  auto forms = instruction_forms();
  unsigned index = 0;
  for (unsigned round = 0; round < rounds; ++round) {
    for (auto& form : forms) {
      if (form.empty() || index == k_most_states) continue;
      const Bytes before = memory.program;
      append_setup(memory.program, index, 0);
      const auto tried = trial.find(form);
      memory.program = before;
      if (!tried) {
        form.clear();
        continue;
      }
      append_setup(memory.program, index, tried->codes);
      append(memory.program, tried->words);
      for (const std::uint32_t whole : tried->registers) append_long(states, whole);
      ++index;
    }
  }
  std::cerr << index << " instructions\n";
  return states;
}

Bytes header() {
  Bytes bytes;
  append(bytes, {0x602e, 0x0104});  // the version keeps the ROM at its address
  for (const std::uint32_t value : {k_program, k_rom, k_program}) append_long(bytes, value);
  return bytes;
}

Image make_image(bool in_memory, unsigned seed) {
  std::mt19937 random(seed);
  Bytes data(in_memory ? k_data_size : 0);
  for (auto& byte : data) byte = static_cast<std::uint8_t>(random());
  TrialMemory memory(k_data, data);
  memory.program_begin = k_program;
  memory.program = start();
  InstructionTrial trial(memory, 0x2700, seed);
  const auto address = [&memory] {
    return k_program + static_cast<std::uint32_t>(memory.program.size());
  };
  Image image{Bytes(k_rom_size), address(), 0};
  const Bytes states = append_instructions(memory, trial, in_memory ? 1 : 4);
  image.end = address();
  append(memory.program, {0x4e71, 0x60fe});
  place(image.rom, k_rom, header());
  place(image.rom, k_program, memory.program);
  place(image.rom, k_rom_data, data);
  place(image.rom, k_states, states);
  return image;
}

void write_file(const std::string& name, const Bytes& bytes) {
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

int execute(const Image& image, const std::string& expected_ram) {
  Bytes memory(0x100'0000);
  std::copy(image.rom.begin(), image.rom.end(), memory.begin() + k_rom);
  NoExternalBus bus;
  Mc68000 processor({memory.data(), 0x100'0000}, bus);
  processor.registers().program_counter = k_program;
  processor.run({1'000'000, image.begin});
  const Account before = processor.account();
  const Stop stop = processor.run({100'000'000, image.end});
  if (stop.reason != StopReason::stop_address) {
    std::cerr << "the program stopped at " << std::hex << stop.instruction_address << ": "
              << name_of(stop.reason) << '\n';
    return 1;
  }
  const Account& after = processor.account();
  std::cout << std::hex << image.begin << ' ' << image.end << std::dec << ' '
            << after.cycles - before.cycles << ' '
            << after.reads + after.writes - before.reads - before.writes << '\n';
  write_file(expected_ram, Bytes(memory.begin() + k_data, memory.begin() + k_data + k_data_size));
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) return 2;
  const bool in_memory = std::string(arguments[3]) == "memory";
  const Image image = make_image(in_memory, static_cast<unsigned>(std::stoul(arguments[4])));
  write_file(arguments[1], image.rom);
  return execute(image, arguments[2]);
}
