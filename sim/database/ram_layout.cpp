#include "sim/database/ram_layout.hpp"

#include <algorithm>

#include "firmware/layout.hpp"

namespace maquette::sim {

namespace {

/// Places one thing behind the other.
class Stacker {
 public:
  void add(std::string_view use, std::int64_t bytes, const void* object = nullptr) {
    const std::int64_t whole_words = bytes + bytes % 2;
    places_.push_back({use, object, end_, whole_words});
    end_ += whole_words;
  }

  template <class Structure>
  void add_array(std::string_view use, const Structure* first, std::size_t count) {
    add(use, static_cast<std::int64_t>(count) * firmware::board_bytes<Structure>(), first);
  }

  [[nodiscard]] std::int64_t end() const { return end_; }
  [[nodiscard]] std::vector<RamPlace> take() { return std::move(places_); }

 private:
  std::vector<RamPlace> places_;
  std::int64_t end_ = 0;
};

void add_prepared(const firmware::Frame<float>& frame, Stacker& stacker) {
  constexpr std::string_view k_use = "preprocessed data";
  const firmware::Database<float>& database = frame.database;
  stacker.add_array(k_use, frame.prepared.leaves, database.leaf_count);
  stacker.add_array(k_use, frame.prepared.extents, database.node_count());
  stacker.add_array(k_use, frame.prepared.surfaces, database.surface_count);
  stacker.add_array(k_use, frame.prepared.light_positions, database.light_count);
  stacker.add_array(k_use, frame.prepared.light_axes,
                    database.needs.shaped_lights ? database.light_count : 0U);
}

void add_pixels_in_flight(const BoardRoom& room, Stacker& stacker) {
  if (room.pixels_in_flight == 0) {
    return;
  }
  const std::int64_t work_area =
      room.crossings * firmware::board_bytes<firmware::Crossing<float>>() +
      room.waiting_rays * firmware::board_bytes<firmware::PendingRay<float>>() + room.stack_bytes;
  const std::int64_t pixels = room.pixels_in_flight;
  stacker.add(k_in_flight_use,
              pixels * firmware::BoardLayout::k_long_bytes + (pixels - 1) * work_area);
}

}  // namespace

RamLayout ram_layout(const firmware::BoardTask<float>& task,
                     const firmware::Conversion<float>& conversion, const BoardPieces& pieces,
                     const BoardRoom& room) {
  RamLayout layout{};
  Stacker stacker;
  stacker.add("system", room.system_bytes);
  stacker.add("firmware code", code_bytes(pieces));
  const auto own_package_bytes = static_cast<std::int64_t>(pieces.code->package.bytes.size());
  stacker.add("arithmetic package", std::max<std::int64_t>(own_package_bytes, room.package_bytes));
  layout.first_loaded_data = stacker.end();
  if (!room.shared_database) {
    for_each_array(task.frame.database, conversion,
                   [&stacker](const auto* first, std::size_t count) {
                     stacker.add_array("database", first, count);
                   });
  }
  stacker.add_array("task", &task, 1);
  if (conversion.given_count > 0) {
    stacker.add_array("task", &conversion, 1);
  }
  layout.loaded_end = stacker.end();
  if (conversion.given_count > 0) {
    stacker.add_array("converted parameters", task.frame.database.parameters,
                      task.frame.database.parameter_count);
  }
  add_prepared(task.frame, stacker);
  stacker.add_array("crossings", task.area.crossings, room.crossings);
  stacker.add_array("waiting rays", task.area.rays, room.waiting_rays);
  stacker.add("line of pixels", firmware::BoardLayout::k_long_bytes * room.line_pixels,
              &task.order.line);
  if (room.own_pixel_bytes > 0) {
    stacker.add("own pixels", room.own_pixel_bytes, &task.order.frame_memory);
  }
  add_pixels_in_flight(room, stacker);
  layout.used_bytes = stacker.end() + room.stack_bytes;
  layout.places = stacker.take();
  layout.places.push_back(
      {"stack", nullptr, std::int64_t{room.ram_bytes} - room.stack_bytes, room.stack_bytes});
  return layout;
}

}  // namespace maquette::sim
