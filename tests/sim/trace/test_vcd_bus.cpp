#include "sim/trace/vcd_bus.hpp"

#include <sstream>

#include "sim/trace/vcd_trace.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

using models::Duration;
using models::Instant;

std::string trace_of(std::uint64_t address, Duration duration) {
  BusRecord record;
  record.window.to = Instant(2 * duration.count());
  record.boards = {{"board0", 4, {}}};
  RecordedAccess access;
  access.grant = Instant(10);
  access.duration = duration;
  access.acknowledge = duration;
  access.address = address;
  record.buses = {{"versabus", 16, {access}, {}}};
  std::ostringstream stream;
  write_vcd_trace(record, {0}, stream);
  return stream.str();
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("An access may last for days and go beyond 32 bits of address") {
  const Duration day(std::int64_t{86'400} * 1'000'000'000'000);
  const std::string text = trace_of((std::uint64_t{1} << 33U) + 5, day);
  CHECK(has(text, "$var wire 64 "));
  CHECK(has(text, "address [63:0] $end\n"));
  CHECK(has(text, "b1000000000000000000000000000000101 "));
  CHECK(has(text, "#86400000000000010\n"));
}

TEST_CASE("Where addresses fit 32 bits the bus has as many") {
  const std::string text = trace_of(0xFFFF'FFFF, Duration(5));
  CHECK(has(text, "address [31:0] $end\n"));
  CHECK_FALSE(has(text, "$var wire 64 "));
}

}  // namespace maquette::sim
