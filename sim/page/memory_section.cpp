#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/database/memory_map.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/page/drawing.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"

namespace maquette::sim {
namespace {

/// The uses that take room, and what is free below the stack, in the order of their addresses.
std::vector<MemoryUse> shown_uses(const MemoryMap& map) {
  std::vector<MemoryUse> uses;
  const MemoryUse& stack = map.uses.back();
  for (const MemoryUse& use : map.uses) {
    if (&use == &stack && map.ram_bytes > map.used_bytes) {
      const std::int64_t free_bytes = map.ram_bytes - map.used_bytes;
      uses.push_back({"free", stack.address - free_bytes, free_bytes});
    }
    if (use.bytes > 0) {
      uses.push_back(use);
    }
  }
  return uses;
}

/// The uses as boxes from the bottom up. Small ones are drawn higher than they are, so that their
/// names can be read.
Html memory_drawing(const std::vector<MemoryUse>& uses, std::int64_t ram_bytes) {
  constexpr double k_least = 20;
  constexpr double k_whole = 300;
  constexpr double k_left = 70;
  constexpr double k_width = 330;
  const auto height_of = [ram_bytes](const MemoryUse& use) {
    return k_least + std::round(k_whole * share_of(static_cast<double>(use.bytes),
                                                   static_cast<double>(ram_bytes)));
  };
  double y = 4;
  for (const MemoryUse& use : uses) {
    y += height_of(use);
  }
  const double height = y + 20;
  Html content = drawn_text(4, height - 4, "address of the lower edge");
  y = 4;
  for (auto use = uses.rbegin(); use != uses.rend(); ++use) {
    const Box box{k_left, y, k_width, height_of(*use)};
    content += labelled_box(box, use->name == "free" ? "free" : "block",
                            {fmt::format("{}: {} bytes", use->name, use->bytes)});
    y += box.height;
    content += drawn_text(4, y - 2, fmt::format("{:06X}", use->address), "code");
  }
  return drawing(k_left + k_width + 4, height, "Memory map of a board; the table below has it",
                 content);
}

Html memory_table(const std::vector<MemoryUse>& uses) {
  PageTable table{
      "Memory map of a board, from the bottom up", {{"use"}, {"address"}, {"bytes", true}}, {}};
  for (const MemoryUse& use : uses) {
    table.rows.push_back({use.name, fmt::format("{:06X}", use.address), std::to_string(use.bytes)});
  }
  return table_element(table);
}

Html work_areas(const MemoryMap& map, const Machine& machine) {
  return table_element(
      {"Work areas: what the scene needs of what is reserved",
       {{"area"}, {"needed", true}, {"reserved", true}},
       {{"crossings", std::to_string(map.crossings_needed),
         std::to_string(machine.crossing_capacity)},
        {"waiting rays", std::to_string(map.rays_needed), std::to_string(machine.ray_capacity)},
        {"bytes of stack", std::to_string(map.stack_needed_bytes),
         std::to_string(machine.stack_bytes)}}});
}

}  // namespace

Html memory_section(const RunResults& results) {
  const Machine& machine = results.description.machine;
  const MemoryMap map = memory_map_of(
      packed_scene<float>(results.description.scene, picture_format_of(machine)), machine);
  const std::vector<MemoryUse> uses = shown_uses(map);
  Html content = paragraph(fmt::format("{} of {} bytes are used; the host loads {} bytes.",
                                       map.used_bytes, map.ram_bytes, map.loaded_bytes));
  if (!map.fits()) {
    content += paragraph(
        fmt::format("The scene does not fit: {} bytes too much.", map.used_bytes - map.ram_bytes));
  }
  return content + memory_drawing(uses, map.ram_bytes) + memory_table(uses) +
         work_areas(map, machine);
}

}  // namespace maquette::sim
