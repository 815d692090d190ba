#include "sim/run/leg_teller.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace maquette::sim {

namespace {

using firmware::counted_meter;

constexpr int k_most_words = std::numeric_limits<std::uint16_t>::max();

/// Calls `visit` with the cell of each function of a kind of ray that has a bit.
template <class Visit>
void for_each_cell(std::uint32_t kind, std::uint64_t functions, Visit visit) {
  firmware::for_each_bit(functions, [&](std::uint32_t function) {
    visit(std::size_t{kind} * firmware::k_function_count + function);
  });
}

/// All that the meter has counted in since its reset; the first kind is never entered.
std::uint64_t rays_of_meter() { return counted_meter.rays | 1U; }

constexpr std::size_t first_cell(std::uint32_t kind) {
  return std::size_t{kind} * firmware::k_function_count;
}

/// The next part begins in it without entering it.
void mark_present_cell() {
  const std::size_t function = counted_meter.cell - counted_meter.first_of_ray;
  counted_meter.rays |= std::uint64_t{1} << counted_meter.ray;
  counted_meter.entered[counted_meter.ray] |= std::uint64_t{1} << function;
}

}  // namespace

LegsApart legs_apart_for(const models::UnitsParameters& units) {
  if (!models::has_units(units)) {
    return all_legs_apart();
  }
  LegsApart apart{};
  for (std::size_t kind = 0; kind < units.kinds.size(); ++kind) {
    for (int stage = 0; stage < models::k_stage_count && units.kinds[kind].number > 0; ++stage) {
      for (std::uint32_t ray = 0; ray < firmware::k_ray_kind_count; ++ray) {
        const models::PixelLeg leg{
            static_cast<models::Stage>(stage), static_cast<firmware::RayKind>(ray), 0, 0, 0, {}};
        if (models::serves(static_cast<models::UnitKind>(kind), leg)) {
          apart[static_cast<std::size_t>(stage)] |= std::uint64_t{1} << ray;
        }
      }
    }
  }
  return apart;
}

LegTeller::LegTeller(const LegsApart& apart)
    : apart_(apart),
      listener_{this,
                [](void* self, firmware::Stage stage, int primitive,
                   const firmware::LegMessages& messages) {
                  static_cast<LegTeller*>(self)->begin(stage, primitive, messages);
                },
                [](void* self, int words) {
                  static_cast<LegTeller*>(self)->parts_.back().messages.returned += words;
                },
                [](void* self) { static_cast<LegTeller*>(self)->end(); }},
      parts_(1) {
  if (counted_meter.listener != nullptr) {
    throw std::logic_error("the legs of a thread have two tellers");
  }
  counted_meter.listener = &listener_;
}

LegTeller::~LegTeller() {
  give_back();
  counted_meter.listener = nullptr;
}

void LegTeller::start() {
  mark_present_cell();
  firmware::for_each_bit(known_rays_ | rays_of_meter(), [this](std::uint32_t kind) {
    firmware::CountedMeter::Cell* const told = told_of(kind);
    for_each_cell(kind, known_[kind] | counted_meter.entered[kind], [told, kind](std::size_t cell) {
      told[cell - first_cell(kind)] = counted_meter.cells[cell];
    });
    known_[kind] = counted_meter.entered[kind];
  });
  known_rays_ = rays_of_meter();
  counted_meter.rays_entered = std::uint64_t{1} << counted_meter.ray;
  most_words_ = 0;
  parts_.assign(1, {});
  legs_.clear();
}

const std::vector<models::PixelLeg>& LegTeller::take() {
  cut(0);
  give_back();
  if (most_words_ > k_most_words) {
    throw std::overflow_error(
        "a part of a pixel's process is handed " + std::to_string(most_words_) + " words, and " +
        std::to_string(k_most_words) + " can be told; fewer bodies in a row take less");
  }
  return legs_;
}

void LegTeller::begin(firmware::Stage stage, int primitive, const firmware::LegMessages& messages) {
  const bool is_boards = (apart_[static_cast<std::size_t>(stage)] >> counted_meter.ray & 1U) == 0;
  if (is_boards && parts_.back().is_boards) {
    ++parts_.back().joined;
    return;
  }
  cut(parts_.back().messages.asked);
  parts_.push_back({stage, primitive, static_cast<firmware::RayKind>(counted_meter.ray), messages,
                    messages.given, 0});
  parts_.back().is_boards = is_boards;
}

void LegTeller::end() {
  if (parts_.back().joined > 0) {
    --parts_.back().joined;
    return;
  }
  cut(parts_.back().messages.returned);
  parts_.pop_back();
  parts_.back().handed_in = parts_.back().messages.resumed;
}

// Parts end in destructors, which must not throw: too many words are told of when the pixel is
// over.
std::uint16_t LegTeller::words_of(int words) {
  most_words_ = std::max(most_words_, words);
  return static_cast<std::uint16_t>(words);
}

// Most kinds of rays are of lights that no scene has.
firmware::CountedMeter::Cell* LegTeller::told_of(std::uint32_t kind) {
  if (told_[kind].empty()) {
    told_[kind].resize(firmware::k_function_count);
  }
  return told_[kind].data();
}

/// What was counted since the last cut becomes a leg of the innermost part.
void LegTeller::cut(int handed_out) {
  Part& part = parts_.back();
  firmware::LongWork work{};
  if (!take_work(part, work)) {
    return;
  }
  firmware::Work counted{};
  for (int i = 0; i < firmware::k_operation_count; ++i) {
    counted.counts[i] = static_cast<std::uint32_t>(work.counts[i]);
  }
  counted = firmware::general_apart(counted);
  // The board's own leg is that of the ray to which it leads.
  const auto ray = part.stage == firmware::Stage::board
                       ? static_cast<firmware::RayKind>(counted_meter.ray)
                       : part.ray;
  if (part.last_leg == 0 || part.last_leg != legs_.size()) {
    legs_.push_back({part.stage,
                     ray,
                     static_cast<std::uint8_t>(part.primitive),
                     words_of(part.handed_in),
                     0,
                     {}});
    part.last_leg = legs_.size();
  }
  models::PixelLeg& leg = legs_.back();
  leg.ray = ray;
  leg.numbers_out = words_of(handed_out);
  for (int i = 0; i < firmware::k_operation_count; ++i) {
    leg.work.counts[i] += counted.counts[i];
  }
}

/// Takes what was counted since the last time; false when that is nothing. A part counts in the
/// cells that were entered while it was the innermost one, for it returns to no other.
bool LegTeller::take_work(Part& part, firmware::LongWork& work) {
  std::uint64_t any = 0;
  cells_.resize(std::max(cells_.size(), parts_.size()));
  Cells& cells = cells_[parts_.size() - 1];
  firmware::for_each_bit(counted_meter.rays_entered, [&](std::uint32_t kind) {
    const std::uint64_t before = (part.rays >> kind & 1U) != 0 ? cells[kind] : 0;
    cells[kind] = before | counted_meter.entered[kind];
    part.rays |= std::uint64_t{1} << kind;
    entered_[kind] |= counted_meter.entered[kind];
    counted_meter.entered[kind] = 0;
    firmware::CountedMeter::Cell* const row = told_of(kind);
    for_each_cell(kind, cells[kind], [&](std::size_t cell) {
      const std::uint64_t* const counts = counted_meter.cells[cell].counts;
      std::uint64_t* const told = row[cell - first_cell(kind)].counts;
      for (std::size_t i = 0; i < firmware::k_operation_count; ++i) {
        const std::uint64_t more = counts[i] - told[i];
        work.counts[i] += more;
        any |= more;
        told[i] = counts[i];
      }
    });
  });
  counted_meter.rays_entered = std::uint64_t{1} << counted_meter.ray;
  mark_present_cell();
  return any != 0;
}

/// The meter's own cells as they would be without a teller.
void LegTeller::give_back() {
  firmware::for_each_bit(rays_of_meter(), [this](std::uint32_t kind) {
    counted_meter.entered[kind] |= entered_[kind];
    known_[kind] |= entered_[kind];
    entered_[kind] = 0;
  });
  known_rays_ |= rays_of_meter();
}

}  // namespace maquette::sim
