#pragma once

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/bus_levels.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/machine/board_places.hpp"
#include "sim/machine/cost_fields.hpp"
#include "sim/machine/machine.hpp"
#include "sim/machine/unit_fields.hpp"

/// Every parameter of a machine, declared once. Marks of the figures: [R] read in the source named,
/// [M] measured on an instruction-level processor, [W] widely stated, [I] inferred here.
namespace maquette::sim {

inline constexpr RealType k_clock{RealDimension::frequency, {1e3, 1e9}};
inline constexpr WholeType k_clocks{WholeDimension::clocks, {0, 100'000}};
inline constexpr WholeType k_time{WholeDimension::time, {0, 1'000'000'000'000}};
inline constexpr WholeType k_memory{WholeDimension::memory, {0, 16 * k_mebibyte}};
/// The board's program has coordinates of 16 bits with a sign, in which the end of a tile that
/// begins in the picture has to be.
inline constexpr WholeType k_side{WholeDimension::pixels, {1, 16384}};
inline constexpr WholeType k_plane{WholeDimension::bits, {1, 8}};

/// RAM, its wait states and its refresh.
template <class Visitor>
void declare_board_memory(Visitor& visitor, models::Kvm02Parameters& board) {
  constexpr WholeType k_wait{WholeDimension::clocks, {0, 100}};
  visitor.field({"ram", "local dynamic RAM of a board", "VM02 data sheet p. 2-51, 2-53 [R]"},
                board.ram_bytes, WholeType{WholeDimension::memory, {1024, 16 * k_mebibyte}});
  visitor.field({"ram_read_wait", "wait states of a local read, parity off, typical",
                 "VM02 data sheet table 1 p. 2-56 [R]"},
                board.ram_read_wait_clocks, k_wait);
  visitor.field({"ram_write_wait", "clocks of a local write beyond four, from its 625 ns typical",
                 "VM02 data sheet table 1 p. 2-56: 5 clocks [R]"},
                board.ram_write_wait_clocks, k_wait);
  visitor.field({"refresh_period", "one RAM cycle is stolen per period; 0 s is off",
                 "usual dynamic RAM refresh, not stated in the VM02 data sheet [I]"},
                board.refresh_period, k_time);
  visitor.field({"refresh", "what the stolen cycle costs",
                 "one cycle of the RAM, not stated in the VM02 data sheet [I]"},
                board.refresh_clocks, k_clocks);
}

/// The board's side of the bus.
template <class Visitor>
void declare_board_bus(Visitor& visitor, models::Kvm02Parameters& board) {
  visitor.field({"access", "off-board access of a fast slave, bus already held",
                 "VM02 data sheet p. 2-57 with a base of 4 clocks [I]"},
                board.access_clocks, WholeType{WholeDimension::clocks, {1, 100'000}});
  visitor.field({"access_slack", "slave access time that costs no extra clock",
                 "VM02 data sheet p. 2-57 [R]"},
                board.access_slack, k_time);
  visitor.field({"word_gap", "between the end of one word's access and the next request",
                 "MC68000 instruction times of a MOVE.W loop body [I]"},
                board.word_gap_clocks, k_clocks);
  visitor.field({"dual_port_access", "access time of the board's RAM seen from the bus",
                 "VM02 data sheet table 1 p. 2-56, taken from the local side [I]"},
                board.dual_port_access, k_time);
  visitor.field(
      {"release", "when the board gives the bus back",
       "VM02 data sheet p. 2-54, indirect method [R]"},
      board.release,
      ChoiceType<models::ReleasePolicy>{{{"each_access", models::ReleasePolicy::each_access},
                                         {"block", models::ReleasePolicy::block}}});
  visitor.field({"pixel_write", "each pixel as soon as it is known, or a line of them together",
                 "choice of the firmware [I]"},
                board.pixel_write,
                ChoiceType<models::PixelWrite>{
                    {{"pixel", models::PixelWrite::pixel}, {"line", models::PixelWrite::line}}});
}

/// What the firmware reserves in a board's RAM.
template <class Visitor>
void declare_board_areas(Visitor& visitor, Machine& machine) {
  visitor.field({"stack", "stack of the firmware", "choice of the firmware [I]"},
                machine.stack_bytes, k_memory);
  visitor.field(
      {"crossings", "entries of the work area for ray crossings", "choice of the firmware [I]"},
      machine.crossing_capacity, WholeType{WholeDimension::count, {2, 1'000'000}});
  visitor.field(
      {"waiting_rays", "entries of the work area for rays that wait", "choice of the firmware [I]"},
      machine.ray_capacity, WholeType{WholeDimension::count, {1, 1'000'000}});
  visitor.field(
      {"system", "monitor and vectors at the bottom of RAM", "usual for a VERSAbug monitor [I]"},
      machine.system_bytes, k_memory);
  visitor.field({"allow_overflow", "simulate although code and scene do not fit the RAM",
                 "the machine could not [I]"},
                machine.allow_memory_overflow, FlagType{});
}

/// Where the board reads the scene.
template <class Visitor>
void declare_board_database(Visitor& visitor, models::Kvm02Parameters& board) {
  visitor.field({"database", "a copy of the scene in each board's RAM, or one in shared_memory",
                 "CCETT paper, section V.2.3.3: duplicated [R]"},
                board.database,
                ChoiceType<models::DatabasePlace>{{{"own_copy", models::DatabasePlace::own_copy},
                                                   {"shared", models::DatabasePlace::shared}}});
  visitor.field({"database_cache", "of a shared database, besides RAM; hits cost what RAM costs",
                 "none on the KVM02, VM02 data sheet p. 2-51 [R]"},
                board.database_cache_bytes, k_memory);
  visitor.group(
      {"database_read", "the datum's part of a load, which a shared database replaces"}, [&] {
        declare_cost(visitor, board.database_read,
                     "MC68000 instruction times: two bus cycles of MOVE.L d16(An),Dn [R]", false);
      });
}

template <class Visitor>
void declare_board(Visitor& visitor, Machine& machine) {
  models::Kvm02Parameters& board = machine.parameters.board;
  visitor.field({"clock", "of the MC68000", "VM02 data sheet p. 2-51, 2-56 [R]"}, board.clock_hz,
                k_clock);
  declare_board_memory(visitor, board);
  visitor.group({"call_overhead", "added to every call of the arithmetic package"}, [&] {
    declare_cost(visitor, board.call_overhead,
                 "the board's program, executed: operands, JSR, result; tools/program_costs [M]",
                 false);
  });
  visitor.group(required("arithmetic", "cost of every operation of arithmetic"),
                [&] { declare_arithmetic(visitor, board.arithmetic, machine.tables); });
  visitor.group(required("program", "cost of every event of the process"),
                [&] { declare_program(visitor, board.arithmetic, machine.tables); });
  visitor.field(
      {"costs",
       "of counted work: told from pixels whose program is executed, where the boards can execute "
       "it, or the tables'",
       "choice of the simulation [I]"},
      machine.cost_origin,
      ChoiceType<CostOrigin>{
          {{"calibrated", CostOrigin::calibrated}, {"tables", CostOrigin::tables}}});
  declare_board_bus(visitor, board);
  declare_board_database(visitor, board);
  declare_board_areas(visitor, machine);
}

template <class Visitor>
void declare_bus(Visitor& visitor, models::VersaBusParameters& bus) {
  visitor.field({"data_width", "data lines", "VM02 data sheet p. 2-56; VERSAbus pin list [R]"},
                bus.data_width_bits, ChoiceType<int>{{{"16 bits", 16}, {"32 bits", 32}}});
  visitor.field({"clock", "in which the clocks below are stated",
                 "clock of the boards, VM02 data sheet p. 2-51 [R]"},
                bus.clock_hz, k_clock);
  visitor.field({"arbitration_clocks", "from bus free and requested to grant",
                 "built up from synchroniser and daisy chain, 3 to 5; sweep 2 to 10 [I]"},
                bus.arbitration_clocks, k_clocks);
  visitor.field({"handover_clocks", "added when the master changes",
                 "address strobe released before the next, 1 to 2 [I]"},
                bus.handover_clocks, k_clocks);
  visitor.field({"arbitration", "which master the arbiter prefers",
                 "VM02 data sheet p. 2-54, 2-58: fixed priority only [R]"},
                bus.arbitration, choices_of(models::k_arbitration_policies));
  visitor.field({"timeout", "of one access; 0 s is off",
                 "VM02 data sheet p. 2-54: 8, 16, 32, 64 us or off [R], 64 us chosen [I]"},
                bus.timeout, k_time);
  visitor.field({"level", "how exactly the bus is simulated", "choice of the simulation [I]"},
                bus.level, choices_of(models::k_bus_levels));
  visitor.field({"quantum", "masters run ahead of one another so long when decoupled; 0 s: exact",
                 "choice of the simulation [I]"},
                bus.quantum, k_time);
}

template <class Visitor>
void declare_frame_memory(Visitor& visitor, models::FrameMemoryParameters& memory) {
  visitor.field({"width", "pixels per line", "CCETT paper, section V.2.3.3 [R]"}, memory.width,
                k_side);
  visitor.field({"height", "lines", "CCETT paper, section V.2.3.3 [R]"}, memory.height, k_side);
  visitor.field({"red", "planes of red", "CCETT paper, section V.2.3.3: 24 bits [R]"},
                memory.red_bits, k_plane);
  visitor.field({"green", "planes of green", "CCETT paper, section V.2.3.3: 24 bits [R]"},
                memory.green_bits, k_plane);
  visitor.field({"blue", "planes of blue", "CCETT paper, section V.2.3.3: 24 bits [R]"},
                memory.blue_bits, k_plane);
  visitor.field({"depth", "planes of depth, written with each pixel; 0: none",
                 "CCETT paper, section V.2.3.3: none [R]"},
                memory.depth_bits, WholeType{WholeDimension::bits, {0, 16}});
  visitor.field({"depth_compare",
                 "a pixel replaces none that is nearer, for which its depth takes two accesses",
                 "16 bits in Z, CCETT paper, section VI [R]; that they are compared [I]"},
                memory.depth_compare, FlagType{});
  visitor.field(
      {"place",
       "of the pixels: one memory on the bus, or the RAM of the board that owns each, from which "
       "the video reader gathers them on a bus of its own; central where it is not given",
       "one memory, CCETT paper, section V.2.3.3 [R]; distributed, the paper's [16], as assumed "
       "here [I]"},
      memory.place,
      ChoiceType<models::FramePlace>{
          {{"central", models::FramePlace::central}, {"boards", models::FramePlace::boards}}});
  visitor.field({"ports", "bus ports, each with a backplane; board b is on port b modulo ports",
                 "one VERSAbus, CCETT paper, section V.2.3.3 [R]"},
                memory.ports, WholeType{WholeDimension::count, {1, 64}});
  visitor.field({"access_time", "data strobe to acknowledge without video conflict",
                 "usual dynamic RAM of the time [I]"},
                memory.access_time, k_time);
  visitor.field({"video_priority", "the video reader's slots delay the bus port",
                 "a picture without gaps needs it [I]"},
                memory.video_priority, FlagType{});
  visitor.field({"video_slot", "pixels fetched by one video slot", "interleaving of planes [I]"},
                memory.video_slot_pixels, WholeType{WholeDimension::pixels, {1, 65535}});
  visitor.field({"video_slot_time", "how long a slot keeps the memory",
                 "cycle of usual dynamic RAM of the time [I]"},
                memory.video_slot_time, k_time);
}

template <class Visitor>
void declare_video(Visitor& visitor, models::VideoParameters& video) {
  constexpr WholeType k_line_number{WholeDimension::count, {1, 10'000}};
  visitor.field({"lines_per_frame", "of both fields, blanking included", "625-line standard [R]"},
                video.lines_per_frame, WholeType{WholeDimension::lines, {2, 10'000}});
  visitor.field({"frames_per_second", "whole frames shown", "625-line standard [R]"},
                video.frames_per_s, WholeType{WholeDimension::count, {1, 1000}});
  visitor.field({"interlaced", "two fields per frame", "625-line standard [R]"}, video.interlaced,
                FlagType{});
  visitor.field({"pixel_clock", "a whole number of its periods makes a line",
                 "usual clock for square pixels in 625 lines [W]"},
                video.pixel_clock_hz, k_clock);
  visitor.field({"first_active_line_field_1", "line number from 1", "CCIR waveform [R]"},
                video.first_active_line_field_1, k_line_number);
  visitor.field({"first_active_line_field_2", "line number from 1", "CCIR waveform [R]"},
                video.first_active_line_field_2, k_line_number);
  visitor.field({"line_blanking", "start of sync to first active pixel", "625-line standard [R]"},
                video.line_blanking, k_time);
}

template <class Visitor>
void declare_host(Visitor& visitor, models::HostParameters& host) {
  visitor.group({"place", "of the EXORmacs on the bus"},
                [&] { declare_place(visitor, host.place, false); });
  visitor.field({"clock", "of the EXORmacs processor", "as the boards [I]"}, host.clock_hz,
                k_clock);
  visitor.field({"word_clocks", "of its copying loop per 16-bit word, besides the access",
                 "MC68000 instruction times: MOVE.W (An)+,(An)+ 12, DBcc 10 [I]"},
                host.word_clocks, k_clocks);
  visitor.field({"loads_code", "the firmware is loaded besides the database",
                 "code of the boards in RAM [I]"},
                host.loads_code, FlagType{});
}

/// The steps of a claim: processor clocks besides the bus accesses, with the two wait states of
/// every read of an instruction from RAM.
template <class Visitor>
void declare_claim(Visitor& visitor, models::ClaimParameters& claim) {
  visitor.field({"modify", "between read and write of the test-and-set cycle",
                 "MC68000 instruction times: TAS 14(2/1) less its instruction and two cycles [R]"},
                claim.modify_clocks, k_clocks);
  visitor.field(
      {"spin", "from a test-and-set that failed to the next, times the number of boards",
       "two turns DBcc 10(2/0) of a delay loop per board, lest the tries fill the bus [I]"},
      claim.spin_clocks, k_clocks);
  visitor.field({"read", "from the test-and-set that succeeded to the counter's read",
                 "MC68000 instruction times: TAS's last fetch 4(1/0), Bcc not taken 8(1/0) [I]"},
                claim.read_clocks, k_clocks);
  visitor.field({"update", "from the counter's read to its write",
                 "MC68000 instruction times: last fetch 4(1/0), MOVE.L 4(1/0), ADDQ.L 8(1/0) [I]"},
                claim.update_clocks, k_clocks);
  visitor.field({"unlock", "from the counter's write to the write that clears the lock",
                 "MC68000 instruction times: last fetch of MOVE.L 4(1/0) [I]"},
                claim.unlock_clocks, k_clocks);
  visitor.field({"finish", "from there to the first pixel of the unit",
                 "MC68000 instruction times: last fetch 4(1/0), CMP.L 6(1/0), Bcc 8(1/0) [I]"},
                claim.finish_clocks, k_clocks);
}

template <class Visitor>
void declare_allotment(Visitor& visitor, models::AllotmentParameters& allotment) {
  visitor.field(
      {"order", "how pixels are given to the boards", "choice of the firmware [I]"},
      allotment.order,
      ChoiceType<models::Allotment>{{{"interleaved_pixels", models::Allotment::interleaved_pixels},
                                     {"interleaved_lines", models::Allotment::interleaved_lines},
                                     {"bands", models::Allotment::bands},
                                     {"tiles", models::Allotment::tiles},
                                     {"interlaced", models::Allotment::interlaced}}});
  visitor.field({"tile_width", "of tiles", "choice of the firmware [I]"}, allotment.tile_width,
                k_side);
  visitor.field({"tile_height", "of tiles", "choice of the firmware [I]"}, allotment.tile_height,
                k_side);
  constexpr WholeType k_part{WholeDimension::count, {1, 256}};
  visitor.field({"columns",
                 "of an interlace, in each of which a board has one; columns times lines is the "
                 "number of boards, as near to a square as it can be where neither is given",
                 "choice of the firmware [I]"},
                allotment.columns, k_part);
  visitor.field({"lines", "of an interlace", "choice of the firmware [I]"}, allotment.lines,
                k_part);
  visitor.field({"assignment", "every n-th of n boards' units, or the next one of a shared counter",
                 "choice of the firmware [I]"},
                allotment.assignment,
                ChoiceType<models::Assignment>{{{"fixed", models::Assignment::fixed},
                                                {"on_demand", models::Assignment::on_demand}}});
  visitor.group({"claim", "of the next unit on demand, by a board"},
                [&] { declare_claim(visitor, allotment.claim); });
}

template <class Visitor>
void declare_shared_memory(Visitor& visitor, models::SharedMemoryParameters& memory) {
  visitor.field({"access_time", "data strobe to acknowledge",
                 "usual dynamic RAM of the time, not found for the M68KVM10 and 11 [I]"},
                memory.access_time, k_time);
}

/// The boards' number and places; `places` overrides the rule.
template <class Visitor>
void declare_board_places(Visitor& visitor, BoardPlaces& boards) {
  visitor.field({"processors", "number of boards", "CCETT paper, section V.2.3.3 [R]"},
                boards.count, WholeType{WholeDimension::count, {1, 256}});
  visitor.group({"boards", "where the boards sit on the bus"}, [&] {
    visitor.field({"request_level", "of all boards, chained in board order; 4 is the highest",
                   "strapped, VM02 data sheet p. 2-53 [R]; level chosen [I]"},
                  boards.request_level, WholeType{WholeDimension::count, {0, 4}});
    visitor.field({"places", "of each board instead: a list of {level, position}",
                   "strapped, VM02 data sheet p. 2-53 [R]"},
                  boards.places, PlaceListType{});
  });
}

/// The fields of a machine description, in the order of the effective configuration.
template <class Visitor>
void declare_machine(Visitor& visitor, Machine& machine) {
  models::MachineParameters& parameters = machine.parameters;
  visitor.field(required("name", "name of the machine"), machine.name, TextType{});
  BoardPlaces boards = to_board_places(parameters.boards);
  declare_board_places(visitor, boards);
  parameters.boards = to_place_list(boards);
  visitor.group(required("board", "each of the KVM02 boards"),
                [&] { declare_board(visitor, machine); });
  visitor.group({"bus", "the VERSAbus"}, [&] { declare_bus(visitor, parameters.bus); });
  visitor.group({"frame_memory", "the picture's memory"},
                [&] { declare_frame_memory(visitor, parameters.frame_memory); });
  visitor.group({"video", "the reader of the frame memory"},
                [&] { declare_video(visitor, parameters.video); });
  visitor.group({"host", "the EXORmacs that loads the boards"},
                [&] { declare_host(visitor, parameters.host); });
  visitor.group({"allotment", "of pixels to boards"},
                [&] { declare_allotment(visitor, parameters.allotment); });
  visitor.group({"shared_memory", "a memory board on the bus, when boards share something"},
                [&] { declare_shared_memory(visitor, parameters.shared_memory); });
  declare_units(visitor, parameters.units, machine.unit_tables);
}

}  // namespace maquette::sim
