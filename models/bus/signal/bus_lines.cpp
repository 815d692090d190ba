#include "models/bus/signal/bus_lines.hpp"

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

}  // namespace maquette::models
