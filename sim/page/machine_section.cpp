#include <fmt/format.h>

#include <algorithm>

#include "sim/fields/quantity.hpp"
#include "sim/page/drawing.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

constexpr double k_box_width = 225;
constexpr double k_gap = 14;
constexpr std::size_t k_boards_in_row = 4;
constexpr std::size_t k_most_boards = 8;
constexpr double k_board_height = 120;
constexpr double k_unit_row_height = 84;
constexpr double k_width = 4 * k_box_width + 3 * k_gap + 8;

std::string clock(double hz) { return format_quantity(hz, RealDimension::frequency); }
std::string memory(std::int64_t bytes) { return format_quantity(bytes, WholeDimension::memory); }
std::string time(models::Duration time) {
  return format_quantity(time.count(), WholeDimension::time);
}

std::vector<std::string> board_lines(const RunResults& results, const BoardStatistics& statistics,
                                     std::size_t place) {
  const models::Kvm02Parameters& board = results.description.machine.parameters.board;
  const models::BusMasterPlace& on_bus = results.description.machine.parameters.boards[place];
  return {statistics.name,
          "processor " + clock(board.clock_hz),
          fmt::format("RAM {}, read wait {}", memory(board.ram_bytes), board.ram_read_wait_clocks),
          "arithmetic " + results.description.machine.tables.arithmetic,
          fmt::format("bus level {}, position {}", on_bus.level, on_bus.position),
          fmt::format("{} pixels, computes {}", statistics.pixels,
                      percent(share_of(in_seconds(statistics.compute),
                                       in_seconds(results.statistics.frame.time))))};
}

/// The boards in rows above the bus, each with a line down to it; of many the first ones.
Html boards_drawing(const RunResults& results, double bus_y) {
  const std::vector<BoardStatistics>& boards = results.statistics.boards;
  const std::size_t shown = std::min(
      {boards.size(), results.description.machine.parameters.boards.size(), k_most_boards});
  Html content;
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t row = i / k_boards_in_row;
    const Box box{4 + static_cast<double>(i % k_boards_in_row) * (k_box_width + k_gap),
                  4 + static_cast<double>(row) * (k_board_height + k_gap), k_box_width,
                  k_board_height - 10};
    const double down = box.x + k_box_width + 2 + 3 * static_cast<double>(row);
    content += drawn_line(box.x + k_box_width, box.y + 20, down, box.y + 20);
    content += drawn_line(down, box.y + 20, down, bus_y);
    content += labelled_box(box, "block", board_lines(results, boards[i], i));
  }
  return content;
}

std::vector<std::string> bus_lines(const RunResults& results) {
  const models::MachineParameters& machine = results.description.machine.parameters;
  const BusStatistics& bus = results.statistics.bus;
  const int ports = machine.frame_memory.ports;
  return {fmt::format("VERSAbus{}, {} bits, {}, arbitration {} of {} clocks, level {}",
                      ports > 1 ? fmt::format(", {} backplanes", ports) : "",
                      machine.bus.data_width_bits, clock(machine.bus.clock_hz),
                      machine.bus.arbitration.name, machine.bus.arbitration_clocks,
                      machine.bus.level.name),
          fmt::format("{} transfers, {} occupied, wait for grant {} in the mean", bus.transfers,
                      percent(bus.occupied, 3), readable_duration(bus.wait_mean))};
}

/// Function units below the bus, in rows; of many the first ones.
Html function_units_drawing(const RunResults& results, double bus_y, double y) {
  const std::vector<FunctionUnitStatistics>& units = results.statistics.units->units;
  Html content;
  for (std::size_t i = 0; i < std::min(units.size(), k_most_boards); ++i) {
    const std::size_t row = i / k_boards_in_row;
    const Box box{4 + static_cast<double>(i % k_boards_in_row) * (k_box_width + k_gap),
                  y + static_cast<double>(row) * k_unit_row_height, k_box_width,
                  k_unit_row_height - k_gap};
    const double up = box.x + k_box_width + 2 + 3 * static_cast<double>(row);
    content += drawn_line(box.x + k_box_width, box.y + 20, up, box.y + 20);
    content += drawn_line(up, box.y + 20, up, bus_y);
    content += labelled_box(
        box, "block",
        {units[i].name,
         fmt::format("{} errands, busy {}", units[i].errands, percent(units[i].utilisation)),
         fmt::format("queue at most {}", units[i].queue_longest)});
  }
  return content;
}

/// What the rows of function units take of the drawing; nothing where there are none.
double height_of_units(const Statistics& statistics) {
  if (!statistics.units) {
    return 0;
  }
  const std::size_t shown = std::min(statistics.units->units.size(), k_most_boards);
  const std::size_t rows = (shown + k_boards_in_row - 1) / k_boards_in_row;
  return k_gap + k_unit_row_height * static_cast<double>(rows);
}

/// What else stands on the bus, besides boards and function units.
Html rest_drawing(const RunResults& results, double bus_y, double y) {
  const models::MachineParameters& machine = results.description.machine.parameters;
  const models::FrameMemoryParameters& memory_of_frame = machine.frame_memory;
  const bool in_boards = models::is_distributed(memory_of_frame);
  const double wide = 1.4 * k_box_width;
  const Box host{4, y, 1.1 * k_box_width, 80};
  const Box frame{host.x + host.width + k_gap, y, wide, 80};
  const Box video{frame.x + frame.width + 2 * k_gap, y, wide, 80};
  // Function units leave the gaps between their columns.
  const bool has_units = results.statistics.units.has_value();
  const double host_x = has_units ? 4 + k_box_width + 0.75 * k_gap : host.x + 20;
  const double frame_x = has_units ? host_x + k_box_width + k_gap : frame.x + 20;
  Html content = drawn_line(host_x, bus_y, host_x, y) + drawn_line(frame_x, bus_y, frame_x, y) +
                 drawn_line(frame.x + frame.width, y + 40, video.x, y + 40);
  content += labelled_box(
      host, "block",
      {"host", "EXORmacs, " + clock(machine.host.clock_hz),
       fmt::format("loads the boards in {}", readable_duration(results.statistics.frame.load))});
  content +=
      labelled_box(frame, "block",
                   {in_boards ? "frame memory, in the boards" : "frame memory",
                    fmt::format("{} x {} pixels", memory_of_frame.width, memory_of_frame.height),
                    fmt::format("{} bits, access {}",
                                memory_of_frame.red_bits + memory_of_frame.green_bits +
                                    memory_of_frame.blue_bits + memory_of_frame.depth_bits,
                                time(memory_of_frame.access_time))});
  content += labelled_box(video, "block",
                          {"video reader",
                           fmt::format("{} lines, {} frames a second",
                                       machine.video.lines_per_frame, machine.video.frames_per_s),
                           fmt::format("pixel clock {}{}", clock(machine.video.pixel_clock_hz),
                                       machine.video.interlaced ? ", interlaced" : "")});
  return content;
}

}  // namespace

Html machine_section(const RunResults& results) {
  const Statistics& statistics = results.statistics;
  const std::size_t boards = statistics.boards.size();
  const std::size_t rows =
      (std::min(boards, k_most_boards) + k_boards_in_row - 1) / k_boards_in_row;
  const double bus_y = 4 + static_cast<double>(rows) * (k_board_height + k_gap);
  const double below = bus_y + 44;
  const double rest_y = below + 20 + height_of_units(statistics);
  Html content = boards_drawing(results, bus_y);
  if (statistics.units) {
    content += function_units_drawing(results, below, below + k_gap);
  }
  content += rest_drawing(results, below, rest_y) +
             labelled_box({4, bus_y, k_width - 8, 44}, "bus", bus_lines(results));
  const models::Kvm02Parameters& board = results.description.machine.parameters.board;
  if (models::is_shared(board.database)) {
    content +=
        drawn_text(4, rest_y + 98, "A memory board on the bus holds the scene for all boards.");
  }
  Html section = drawing(k_width + 12, rest_y + 106, "Block diagram of the machine", content);
  if (boards > k_most_boards) {
    section += paragraph(fmt::format("The first {} of {} boards are drawn; the tables have all.",
                                     k_most_boards, boards));
  }
  if (statistics.units && statistics.units->units.size() > k_most_boards) {
    section += paragraph(fmt::format("The first {} of {} units are drawn; the tables have all.",
                                     k_most_boards, statistics.units->units.size()));
  }
  return section;
}

}  // namespace maquette::sim
