#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/trace_format.hpp"

namespace maquette::sim {

/// Writes a record as a value change dump (IEEE 1364, chapter 18; GTKWave opens it) with a
/// resolution of 1 ps, time 0 being the frame's start. A name that ends in _n is active low, as the
/// signal with a star is on the backplane.
///
/// One scope per bus: BR0_n..BR4_n (a board of this level waits for its grant), BG0_n..BG4_n (from
/// the begin of the arbitration to the grant), BBSY_n (from the grant to the release), AS_n and
/// DS_n (from the grant to the end of the access), DTACK_n (from the slave's answer to the end) and
/// BERR_n (likewise when none came), WRITE_n, address, data and owner, the number of the board that
/// has the bus; the last four float while nobody has it. A read-modify-write cycle is shown as one
/// long read. One scope per board of `boards`, whose signals begin with its name: state (0
/// computes, 1 waits for its grant, 2 transfers, 3 idle) and its own BR_n. One scope of the video
/// reader where it was looked at (dump_video). What lasts no time is not seen.
void write_vcd_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                     std::ostream& stream);

/// About how long write_vcd_trace's output will be.
std::int64_t expected_vcd_trace_bytes(const BusRecord& record);

/// Writes a save file of GTKWave that shows all signals of the dump `trace`, in a group for each
/// scope.
void write_gtkwave_view(const BusRecord& record, const std::vector<std::size_t>& boards,
                        const std::string& trace, std::ostream& stream);

/// A comment, as the viewer's own files have them.
inline constexpr std::string_view k_gtkwave_mark = "[*] Written by maquette beside its trace";

/// Value change dumps as a format of trace files.
inline constexpr TraceFormat k_vcd_trace{".vcd",  write_vcd_trace, expected_vcd_trace_bytes,
                                         ".gtkw", k_gtkwave_mark,  write_gtkwave_view};

}  // namespace maquette::sim
