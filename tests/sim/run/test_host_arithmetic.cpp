#include "sim/run/host_arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "firmware/arithmetic/elementary.hpp"
#include "tests/catch.hpp"

using namespace maquette;
using firmware::FfpFormat;
using firmware::IeeeSingleFormat;
using firmware::Operation;
using namespace models::mc68000;

namespace {

/// A processor that calls routines of a board's program, which the host executes.
class Caller {
 public:
  explicit Caller(firmware::NumberFormat numbers)
      : program_(sim::linked_program(0x2000, sim::all_pieces(sim::program_code(numbers)))),
        ram_(1U << 20U),
        processor_({ram_.data(), static_cast<std::uint32_t>(ram_.size())}, bus_) {
    std::copy(program_.bytes.begin(), program_.bytes.end(), ram_.begin() + program_.base);
    sim::host_arithmetic(program_)(routines_, work_);
    processor_.use(routines_);
  }

  /// Calls with operands in D7 and D6 and behind the return address, as either kind of routine
  /// takes them; then D0 and D1 tell by SLT and SLE of the conditions.
  void call(std::uint32_t address, std::uint32_t left, std::uint32_t right) {
    constexpr std::uint32_t k_start = 0x1000;
    constexpr std::uint32_t k_stack = 0x1800;
    work_ = {};
    put(k_start, {0x4EB9, address >> 16U, address & 0xFFFFU, 0x5DC2, 0x5FC1, 0x4E72, 0x2700});
    put(k_stack, {left >> 16U, left & 0xFFFFU, right >> 16U, right & 0xFFFFU});
    Registers& registers = processor_.registers();
    registers.program_counter = k_start;
    registers.stack() = k_stack;
    registers.data(7) = left;
    registers.data(6) = right;
    REQUIRE(processor_.run({}).reason == StopReason::stop_instruction);
    REQUIRE(registers.stack() == k_stack);
  }

  [[nodiscard]] std::uint32_t routine(std::uint32_t firmware::ArithmeticPackage::*entry) const {
    return program_.package + program_.code->package.*entry;
  }
  [[nodiscard]] std::uint32_t function(const char* name) const {
    return address_of(program_, name);
  }
  std::uint32_t data(unsigned number) { return processor_.registers().data(number); }
  [[nodiscard]] bool is_less() { return (data(2) & 0xFFU) != 0; }
  [[nodiscard]] bool is_less_or_equal() { return (data(1) & 0xFFU) != 0; }
  [[nodiscard]] std::uint32_t count(Operation operation) const { return work_[operation]; }

 private:
  void put(std::uint32_t address, std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) {
      ram_[address++] = static_cast<unsigned char>(word >> 8U);
      ram_[address++] = static_cast<unsigned char>(word);
    }
  }

  sim::LinkedProgram program_;
  std::vector<unsigned char> ram_;
  NoExternalBus bus_;
  Mc68000 processor_;
  NativeCalls routines_;
  firmware::Work work_{};
};

/// Numbers of the format of every kind, zeros of both signs, infinities and NaN among them.
template <class Format>
std::vector<float> operands() {
  std::vector<float> values;
  const auto add = [&values](float value) {
    values.push_back(Format::value_of(Format::bits_of(value)));
  };
  for (const float value : {0.0F, 1.0F, 1e-45F, 1e-30F, 0x1p-65F, 2.5F, 1e18F, 3e38F, HUGE_VALF}) {
    add(value);
    add(-value);
  }
  std::mt19937 random(1);
  for (int i = 0; i < 40; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    const auto value = __builtin_bit_cast(float, bits);
    add(std::isfinite(value) ? value : 1);
  }
  return values;
}

template <>
std::vector<float> operands<IeeeSingleFormat>() {
  std::vector<float> values = operands<FfpFormat>();
  for (const float value : {-0.0F, 1e-45F, -1e-30F, 3e38F, HUGE_VALF, -HUGE_VALF, NAN}) {
    values.push_back(value);
  }
  return values;
}

template <class Format>
void check_result(std::uint32_t bits, float expected) {
  if (std::isnan(expected)) {
    CHECK(std::isnan(Format::value_of(bits)));
  } else {
    CHECK(bits == Format::bits_of(expected));
  }
}

template <class Format>
void check_operators(firmware::NumberFormat numbers) {
  using Package = firmware::ArithmeticPackage;
  Caller caller(numbers);
  for (const float a : operands<Format>()) {
    for (const float b : operands<Format>()) {
      INFO(a << " and " << b);
      const auto called = [&](std::uint32_t Package::*entry) {
        caller.call(caller.routine(entry), Format::bits_of(a), Format::bits_of(b));
        return caller.data(7);
      };
      check_result<Format>(called(&Package::add), a + b);
      check_result<Format>(called(&Package::subtract), a - b);
      check_result<Format>(called(&Package::multiply), a * b);
      if (b != 0 || numbers == firmware::NumberFormat::ieee_single) {
        check_result<Format>(called(&Package::divide), a / b);
      }
      called(&Package::compare);
      CHECK(caller.is_less() == (a < b));
      CHECK(caller.is_less_or_equal() == (a <= b));
    }
  }
}

template <class Format>
void check_functions(firmware::NumberFormat numbers) {
  using Package = firmware::ArithmeticPackage;
  Caller caller(numbers);
  for (const float a : {0.0F, 0.25F, 0.7F, 1.0F}) {
    INFO(a);
    const auto called = [&](std::uint32_t address) {
      caller.call(address, Format::bits_of(a), Format::bits_of(3));
    };
    called(caller.routine(&Package::square_root));
    check_result<Format>(caller.data(7), std::sqrt(a));
    called(caller.function("arithmetic_exponential"));
    check_result<Format>(caller.data(0), firmware::exponential(a));
    called(caller.function("arithmetic_power"));
    check_result<Format>(caller.data(0), firmware::power(a, 3.0F));
    called(caller.function("arithmetic_arc_cosine"));
    check_result<Format>(caller.data(0), firmware::arc_cosine(a));
  }
  for (const std::int32_t integer : {0, 1, -7, 16'777'217, -2'000'000'001}) {
    caller.call(caller.routine(&Package::from_integer), static_cast<std::uint32_t>(integer), 0);
    check_result<Format>(caller.data(7), static_cast<float>(integer));
  }
  for (const float value : {0.0F, 0.9F, -1.9F, 1e9F}) {
    caller.call(caller.routine(&Package::to_integer), Format::bits_of(value), 0);
    CHECK(static_cast<std::int32_t>(caller.data(7)) == static_cast<std::int32_t>(value));
  }
}

TEST_CASE("routines give the bits of the host's float, with what is zero or not a number as well") {
  check_operators<IeeeSingleFormat>(firmware::NumberFormat::ieee_single);
  check_functions<IeeeSingleFormat>(firmware::NumberFormat::ieee_single);
}

TEST_CASE("in the FFP format they give the same, within its range") {
  check_operators<FfpFormat>(firmware::NumberFormat::ffp);
  check_functions<FfpFormat>(firmware::NumberFormat::ffp);
}

TEST_CASE("a zero operand of either sign makes another operation, as counting has it") {
  using Package = firmware::ArithmeticPackage;
  Caller caller(firmware::NumberFormat::ieee_single);
  const auto counted = [&](std::uint32_t Package::*entry, float a, float b, Operation operation) {
    caller.call(caller.routine(entry), IeeeSingleFormat::bits_of(a), IeeeSingleFormat::bits_of(b));
    return caller.count(operation);
  };
  CHECK(counted(&Package::add, 1, 2, Operation::add) == 1);
  CHECK(counted(&Package::add, -0.0F, 2, Operation::add_zero) == 1);
  CHECK(counted(&Package::subtract, 2, -0.0F, Operation::subtract_zero) == 1);
  CHECK(counted(&Package::multiply, -0.0F, 2, Operation::multiply_zero) == 1);
  CHECK(counted(&Package::multiply, -1e-30F, 1e-30F, Operation::multiply_zero) == 1);
  CHECK(counted(&Package::divide, -0.0F, 2, Operation::divide_zero) == 1);
  CHECK(counted(&Package::divide, 2, -1, Operation::divide) == 1);
  CHECK(counted(&Package::compare, 2, -0.0F, Operation::compare) == 1);
}

}  // namespace
