#include "tools/benchmark/calibration_loop.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <stdexcept>
#include <vector>

#include "tools/benchmark/median.hpp"

namespace maquette::benchmark {

namespace {

constexpr std::size_t k_words = 0x4000;

std::vector<std::uint32_t> scattered_words() {
  std::vector<std::uint32_t> words(k_words);
  std::uint32_t value = 1;
  for (std::uint32_t& word : words) {
    value = value * 1664525U + 1013904223U;
    word = value;
  }
  return words;
}

std::uint32_t run_steps(std::vector<std::uint32_t>& words) {
  std::uint32_t state = 1;
  for (std::uint32_t step = 0; step < static_cast<std::uint32_t>(k_calibration_steps); ++step) {
    std::uint32_t& word = words[(state >> 9U) % k_words];
    if ((word & 0x100U) != 0) {
      state = state * 3U + word;
    } else {
      state = (state ^ word) + step;
    }
    word += state >> 16U;
  }
  return state;
}

}  // namespace

double calibration_loop_s() {
  std::vector<double> times;
  std::array<std::uint32_t, 9> ends{};
  for (std::uint32_t& end : ends) {
    std::vector<std::uint32_t> words = scattered_words();
    const std::clock_t begin = std::clock();
    end = run_steps(words);
    times.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  for (const std::uint32_t end : ends) {
    if (end != ends.front()) {
      throw std::logic_error("the calibration loop does not repeat itself");
    }
  }
  return median(times);
}

}  // namespace maquette::benchmark
