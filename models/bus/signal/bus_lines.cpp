#include "models/bus/signal/bus_lines.hpp"

#include <string>

namespace maquette::models {

namespace {

BusLine* make_high(const char* name, std::size_t /*index*/) {
  return new BusLine(name, sc_dt::SC_LOGIC_Z);
}

}  // namespace

BusLines::BusLines()
    : request("BR_n", k_levels, make_high),
      grant("BG_n", k_levels, make_high),
      busy("BBSY_n", sc_dt::SC_LOGIC_Z),
      clear("BCLR_n", sc_dt::SC_LOGIC_Z),
      address_strobe("AS_n", sc_dt::SC_LOGIC_Z),
      upper_strobe("DS0_n", sc_dt::SC_LOGIC_Z),
      lower_strobe("DS1_n", sc_dt::SC_LOGIC_Z),
      write("WRITE_n", sc_dt::SC_LOGIC_Z),
      acknowledge("DTACK_n", sc_dt::SC_LOGIC_Z),
      error("BERR_n", sc_dt::SC_LOGIC_Z),
      address("address"),
      data("data") {}

void trace_lines(sc_core::sc_trace_file* file, const BusLines& lines) {
  const auto trace = [file](const auto& line) { sc_core::sc_trace(file, line, line.name()); };
  for (const auto* levels : {&lines.request, &lines.grant}) {
    for (const BusLine& line : *levels) {
      trace(line);
    }
  }
  for (const BusLine* line :
       {&lines.busy, &lines.clear, &lines.address_strobe, &lines.upper_strobe, &lines.lower_strobe,
        &lines.write, &lines.acknowledge, &lines.error}) {
    trace(*line);
  }
  trace(lines.address);
  trace(lines.data);
}

}  // namespace maquette::models
