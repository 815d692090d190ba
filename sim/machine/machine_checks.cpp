#include "sim/machine/machine_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "models/bus/instant.hpp"
#include "models/display/video_gaps.hpp"
#include "models/machine/address_blocks.hpp"
#include "sim/fields/quantity.hpp"
#include "sim/machine/unit_checks.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr double k_ps_per_s = 1e12;

[[noreturn]] void fail(const YamlNode& node, std::string_view path, const std::string& message) {
  throw DescriptionError(node.place.position(), std::string{path} + ": " + message);
}

[[noreturn]] void fail_at(const YamlNode& root, std::string_view path, const std::string& message) {
  fail(nearest_node(root, path), path, message);
}

std::string divisors_of(int number) {
  std::string list;
  for (int divisor = 1; divisor <= number; ++divisor) {
    if (number % divisor == 0) {
      list += (list.empty() ? "" : ", ") + std::to_string(divisor);
    }
  }
  return list;
}

void check_board_count(const Machine& machine, const YamlNode& root) {
  const YamlNode* boards = root.find("boards");
  const YamlNode* places = boards == nullptr ? nullptr : boards->find("places");
  if (places == nullptr) {
    return;
  }
  if (boards->find("request_level") != nullptr) {
    fail(*places, "boards.places", "request_level is given too; one of them is allowed");
  }
  const YamlNode* processors = root.find("processors");
  const std::size_t count = machine.parameters.boards.size();
  if (processors != nullptr &&
      parse_quantity(processors->text, WholeDimension::count) != static_cast<std::int64_t>(count)) {
    fail(*places, "boards.places",
         std::to_string(count) + " places are listed for " + processors->text + " processors");
  }
}

void check_places(const Machine& machine, const YamlNode& root) {
  std::map<std::pair<int, int>, std::string> taken;
  const auto take = [&](const models::BusMasterPlace& place, const std::string& master,
                        std::string_view path) {
    const auto [other, is_new] = taken.try_emplace({place.level, place.position}, master);
    if (!is_new) {
      fail_at(root, path,
              master + " is at level " + std::to_string(place.level) + ", position " +
                  std::to_string(place.position) + ", and so is " + other->second +
                  "; each master needs its own place");
    }
  };
  const auto& boards = machine.parameters.boards;
  for (std::size_t i = 0; i < boards.size(); ++i) {
    take(boards[i], "board " + std::to_string(i), "boards.places");
  }
  take(machine.parameters.host.place, "the host", "host.place");
  for (std::size_t kind = 0, unit = 0; kind < models::k_unit_kind_count; ++kind) {
    const models::FunctionUnitParameters& units = machine.parameters.units.kinds[kind];
    for (int i = 0; i < units.number; ++i, ++unit) {
      const std::string name = models::k_unit_kind_names[kind];
      take(models::unit_place(units, boards.size(), unit), name + " unit " + std::to_string(i),
           "units." + name + ".request_level");
    }
  }
}

/// Lines of the picture in each field.
std::pair<int, int> lines_per_field(const models::MachineParameters& parameters) {
  const int height = parameters.frame_memory.height;
  return parameters.video.interlaced ? std::pair{(height + 1) / 2, height / 2}
                                     : std::pair{height, 0};
}

void check_picture_lines(const models::MachineParameters& parameters, const YamlNode& root) {
  const models::VideoParameters& video = parameters.video;
  const auto [first, second] = lines_per_field(parameters);
  const int last_of_first = video.first_active_line_field_1 + first - 1;
  const int last_of_second = video.first_active_line_field_2 + second - 1;
  const int end_of_first =
      video.interlaced ? video.first_active_line_field_2 - 1 : video.lines_per_frame;
  if (last_of_first > end_of_first) {
    fail_at(root, "frame_memory.height",
            "its first field ends in line " + std::to_string(last_of_first) +
                "; the video standard allows line " + std::to_string(end_of_first));
  }
  if (video.interlaced && last_of_second > video.lines_per_frame) {
    fail_at(root, "frame_memory.height",
            "its second field ends in line " + std::to_string(last_of_second) +
                "; the video standard allows line " + std::to_string(video.lines_per_frame));
  }
}

void check_picture_width(const models::MachineParameters& parameters, const YamlNode& root) {
  const models::VideoParameters& video = parameters.video;
  const double line_rate = static_cast<double>(video.lines_per_frame) * video.frames_per_s;
  const double clocks = video.pixel_clock_hz / line_rate;
  if (clocks != std::floor(clocks)) {
    fail_at(root, "video.pixel_clock",
            "gives " + format_quantity(clocks, RealDimension::number) +
                " periods per line; a whole number is allowed, so a multiple of " +
                format_quantity(line_rate, RealDimension::frequency));
  }
  const double blanking =
      static_cast<double>(video.line_blanking.count()) / k_ps_per_s * video.pixel_clock_hz;
  if (blanking + parameters.frame_memory.width > clocks) {
    fail_at(
        root, "frame_memory.width",
        "does not fit in a line; the video standard allows " +
            format_quantity(std::max(std::floor(clocks - blanking), 0.0), RealDimension::number) +
            " pixels");
  }
}

std::string all_boards(const models::MachineParameters& parameters) {
  const std::size_t count = parameters.boards.size();
  return count == 1 ? "board0" : "board0 to board" + std::to_string(count - 1);
}

void check_video_slots(const models::MachineParameters& parameters, const YamlNode& root) {
  const models::FrameMemoryParameters& memory = parameters.frame_memory;
  const models::VideoParameters& video = parameters.video;
  if (!models::has_video_slots(memory)) {
    return;
  }
  const std::int64_t lines_per_s = std::int64_t{video.lines_per_frame} * video.frames_per_s;
  const models::VideoGaps gaps =
      models::video_gaps({static_cast<std::int64_t>(k_ps_per_s), lines_per_s},
                         models::Period::of_frequency(video.pixel_clock_hz), memory.width,
                         video.line_blanking, memory);
  const auto at_most = [](models::Duration time) {
    return format_quantity(std::max<std::int64_t>(time.count(), 0), WholeDimension::time) +
           " is allowed";
  };
  if (gaps.within_line <= models::Duration::zero() || gaps.after_last < models::Duration::zero()) {
    const models::Duration excess = std::min(gaps.within_line - models::k_tick, gaps.after_last);
    fail_at(root, "frame_memory.video_slot_time",
            "leaves nothing to the bus, so that " + all_boards(parameters) +
                " would starve; at most " + at_most(memory.video_slot_time + excess));
  }
  if (gaps.narrowest() < memory.access_time) {
    fail_at(root, "frame_memory.access_time",
            "never fits between the slots of the video reader, so that " + all_boards(parameters) +
                " would starve; at most " + at_most(gaps.narrowest()));
  }
}

void check_planes(const models::FrameMemoryParameters& memory, const YamlNode& root) {
  constexpr int k_most_colour_bits = 16;
  const int colour_bits = memory.red_bits + memory.green_bits + memory.blue_bits;
  if (memory.depth_bits > 0 && colour_bits > k_most_colour_bits) {
    fail_at(root, "frame_memory.depth",
            "stands beside " + std::to_string(colour_bits) +
                " bits of colour; with depth planes red, green and blue have at most 16 together");
  }
}

/// The colour of a pixel waits for its depth, and there is one place to wait in.
void check_depth_compare(const models::MachineParameters& parameters, const YamlNode& root) {
  constexpr int k_pixel_bits = 32;
  if (!parameters.frame_memory.depth_compare) {
    return;
  }
  if (parameters.frame_memory.depth_bits == 0) {
    fail_at(root, "frame_memory.depth_compare",
            "there is no depth to compare; allowed with frame_memory.depth of 1 to 16 bits");
  }
  if (models::compares_depth(parameters.frame_memory) &&
      !models::is_distributed(parameters.frame_memory) && parameters.boards.size() > 1 &&
      parameters.bus.data_width_bits != k_pixel_bits) {
    fail_at(root, "frame_memory.depth_compare",
            "between colour and depth of one board's pixel another's may come; allowed with one "
            "processor, with a bus.data_width of 32 bits, or with frame_memory.place=boards");
  }
}

/// The video reader must know the owner of a pixel from its place on the screen, whatever the
/// scene.
void check_distribution(const models::MachineParameters& parameters, const YamlNode& root) {
  if (!models::is_distributed(parameters.frame_memory)) {
    return;
  }
  const auto require = [&root](bool holds, const std::string& message) {
    if (!holds) {
      fail_at(root, "frame_memory.place", message);
    }
  };
  require(!models::is_claimed(parameters.allotment.assignment),
          "nobody knows beforehand whose a pixel is that boards claim; boards is allowed with "
          "allotment.assignment=fixed");
  require(parameters.allotment.order == models::Allotment::interlaced,
          "the owner of a pixel must follow from its place on the screen, whatever the useful zone "
          "is; boards is allowed with allotment.order=interlaced");
  require(!models::keeps_line(parameters.board.pixel_write),
          "pixels in a board's own RAM gain nothing from waiting for their line; boards is allowed "
          "with board.pixel_write=pixel");
  require(parameters.frame_memory.ports == 1,
          "there is no frame memory on the bus; boards is allowed with frame_memory.ports=1");
}

void check_board(const Machine& machine, const YamlNode& root) {
  const models::Kvm02Parameters& board = machine.parameters.board;
  if (machine.stack_bytes + machine.system_bytes >= board.ram_bytes) {
    fail_at(root, "board.ram", "holds not even the stack and the system");
  }
  const double refresh_ps = static_cast<double>(board.refresh_clocks) / board.clock_hz * k_ps_per_s;
  if (board.refresh_period.count() != 0 &&
      refresh_ps >= static_cast<double>(board.refresh_period.count())) {
    fail_at(root, "board.refresh", "leaves nothing of the period to the processor");
  }
}

/// All that stands on the bus has addresses, with a block for what boards may share.
void check_addresses(const models::MachineParameters& parameters, const YamlNode& root) {
  const std::size_t boards = parameters.boards.size();
  const auto fits = [&](std::uint64_t block) {
    return models::shared_base(block, boards, parameters.frame_memory) + block <=
           models::k_end_of_addresses;
  };
  std::uint64_t block = models::block_of(parameters.board.ram_bytes);
  if (fits(block)) {
    return;
  }
  while (!fits(block)) {
    block /= 2;
  }
  fail_at(root, "board.ram",
          std::to_string(boards) +
              " boards with so much and the frame memory need more than the 32 bits of the bus's "
              "addresses; at most " +
              format_quantity(static_cast<std::int64_t>(block), WholeDimension::memory) +
              " is allowed");
}

/// As interlace_of, with the place and the divisors that are allowed.
void check_interlace(const models::MachineParameters& parameters, const YamlNode& root) {
  const models::AllotmentParameters& allotment = parameters.allotment;
  const int boards = static_cast<int>(parameters.boards.size());
  if (allotment.order != models::Allotment::interlaced) {
    if (allotment.columns || allotment.lines) {
      fail_at(root, allotment.columns ? "allotment.columns" : "allotment.lines",
              "is of an interlace; allowed with allotment.order=interlaced");
    }
    return;
  }
  const auto check = [&](std::optional<int> part, std::string_view path) {
    if (part && boards % *part != 0) {
      fail_at(root, path,
              std::to_string(boards) + " boards cannot be shared out over " +
                  std::to_string(*part) + "; allowed: " + divisors_of(boards));
    }
  };
  check(allotment.columns, "allotment.columns");
  check(allotment.lines, "allotment.lines");
  if (allotment.columns && allotment.lines && *allotment.columns * *allotment.lines != boards) {
    fail_at(root, "allotment.lines",
            std::to_string(*allotment.columns) + " columns and " +
                std::to_string(*allotment.lines) + " lines are not the " + std::to_string(boards) +
                " boards; allowed: " + std::to_string(boards / *allotment.columns));
  }
}

/// Backplanes keep their own time, so what boards of several do to one counter has no exact order.
void check_ports(const models::MachineParameters& parameters, const YamlNode& root) {
  if (models::is_claimed(parameters.allotment.assignment) && parameters.frame_memory.ports > 1) {
    fail_at(root, "allotment.assignment",
            "on_demand is allowed with frame_memory.ports=1 only, whose bus orders the claims");
  }
}

void check_timeout(const models::MachineParameters& parameters, const YamlNode& root) {
  const models::Duration timeout = parameters.bus.timeout;
  const models::FrameMemoryParameters& memory = parameters.frame_memory;
  if (timeout.count() == 0) {
    return;
  }
  const auto check = [&](models::Duration access, std::string_view path) {
    if (access >= timeout) {
      fail_at(root, path, "is not below bus.timeout, so every access would be a bus error");
    }
  };
  check(parameters.board.dual_port_access, "board.dual_port_access");
  check(parameters.shared_memory.access_time, "shared_memory.access_time");
  check(memory.access_time, "frame_memory.access_time");
  const int accesses = models::compares_depth(memory) ? 2 : 1;
  if (accesses > 1) {
    check(accesses * memory.access_time, "frame_memory.depth_compare");
  }
  if (models::has_video_slots(memory)) {
    check(accesses * (memory.access_time + memory.video_slot_time), "frame_memory.video_slot_time");
  }
}

}  // namespace

void check_machine(const Machine& machine, const YamlNode& root) {
  check_board_count(machine, root);
  check_places(machine, root);
  check_board(machine, root);
  check_addresses(machine.parameters, root);
  check_planes(machine.parameters.frame_memory, root);
  check_depth_compare(machine.parameters, root);
  check_picture_width(machine.parameters, root);
  check_picture_lines(machine.parameters, root);
  check_video_slots(machine.parameters, root);
  check_timeout(machine.parameters, root);
  check_ports(machine.parameters, root);
  check_distribution(machine.parameters, root);
  check_interlace(machine.parameters, root);
  check_units(machine, root);
}

}  // namespace maquette::sim
