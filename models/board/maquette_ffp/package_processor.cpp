#include "models/board/maquette_ffp/package_processor.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "firmware/arithmetic/maquette_ffp/package.hpp"

namespace maquette::models {

namespace {

using mc68000::Account;

// The stack below the program holds two return addresses, as deep as the package calls itself, and
// the caller's, which is zero.
constexpr std::uint32_t k_program = 16;
constexpr std::uint32_t k_return_address = 0;
constexpr std::uint32_t k_size = k_program + sizeof firmware::maquette_ffp::k_package;

}  // namespace

PackageProcessor::PackageProcessor()
    : memory_(k_size + k_size % 2),
      processor_({memory_.data(), static_cast<std::uint32_t>(memory_.size())}, bus_) {
  std::copy(std::begin(firmware::maquette_ffp::k_package),
            std::end(firmware::maquette_ffp::k_package), memory_.begin() + k_program);
}

PackageCall PackageProcessor::call(std::uint32_t entry, std::uint32_t d7, std::uint32_t d6) {
  registers().stack() = k_program - 4;
  registers().program_counter = k_program + entry;
  registers().data(6) = d6;
  registers().data(7) = d7;
  const Account before = processor_.account();
  mc68000::RunLimit limit;
  limit.stop_address = k_return_address;
  const mc68000::Stop stop = processor_.run(limit);
  if (stop.reason != mc68000::StopReason::stop_address) {
    throw std::logic_error(std::string("the arithmetic package ended in ") +
                           mc68000::name_of(stop.reason));
  }
  const Account& after = processor_.account();
  return {registers().data(7), registers().conditions,
          static_cast<unsigned>(after.cycles - before.cycles),
          static_cast<unsigned>(after.fetches + after.reads - before.fetches - before.reads),
          static_cast<unsigned>(after.writes - before.writes)};
}

}  // namespace maquette::models
