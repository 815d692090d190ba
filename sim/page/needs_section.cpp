#include <fmt/format.h>

#include "sim/database/board_code.hpp"
#include "sim/database/needs.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"

namespace maquette::sim {

Html needs_section(const RunResults& results) {
  const Machine& machine = results.description.machine;
  const PackedScene<float> packed =
      packed_scene<float>(results.description.scene, picture_format_of(machine));
  const firmware::Database<float> database = packed.database();
  const firmware::ProgramCode& code =
      program_code(models::numbers_of(machine.parameters.board.arithmetic));
  const std::int64_t linked_bytes = code_bytes(needed_pieces(code, database.needs));
  std::string needed;
  PageTable left_out{
      "Left out of the boards' program, and the bytes of code that each alone would "
      "add",
      {{"left out"}, {"bytes", true}},
      {}};
  for (const NamedNeed& need : named_needs(database.needs)) {
    if (need.is_needed) {
      needed += (needed.empty() ? "" : ", ") + need.name;
    } else {
      left_out.rows.push_back(
          {need.name, std::to_string(code_bytes(needed_pieces(code, need.with)) - linked_bytes)});
    }
  }
  return definitions(
             {{"Scene",
               fmt::format("{} primitives, {} composites, {} surfaces, {} lights; a tree "
                           "{} high",
                           database.leaf_count, database.composite_count, database.surface_count,
                           database.light_count, packed.tree_height)},
              {"Needed", needed.empty() ? "nothing" : needed},
              {"Saved", fmt::format("{} bytes of code by all that is left out together",
                                    code_bytes(all_pieces(code)) - linked_bytes)}}) +
         folded("What is left out", table_element(left_out));
}

}  // namespace maquette::sim
