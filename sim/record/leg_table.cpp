#include "sim/record/leg_table.hpp"

#include <algorithm>
#include <cstddef>

#include "firmware/arithmetic/counted_meter.hpp"
#include "firmware/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

using models::PixelLeg;
using Words = std::vector<std::uint32_t>;

constexpr unsigned k_half = 16;
constexpr std::uint32_t k_half_mask = 0xFFFF;
constexpr unsigned k_byte = 8;
constexpr std::uint32_t k_byte_mask = 0xFF;

/// What it is and what is handed over; so many classes of its work, each with its count.
void append(const PixelLeg& leg, Words& words) {
  words.push_back(static_cast<std::uint32_t>(leg.stage) |
                  static_cast<std::uint32_t>(leg.ray) << k_byte |
                  std::uint32_t{leg.primitive} << (2 * k_byte));
  words.push_back(leg.numbers_in | std::uint32_t{leg.numbers_out} << k_half);
  const std::size_t classes = words.size();
  words.push_back(0);
  for (std::uint32_t i = 0; i < firmware::k_operation_count; ++i) {
    if (leg.work.counts[i] != 0) {
      ++words[classes];
      words.push_back(i);
      words.push_back(leg.work.counts[i]);
    }
  }
}

std::string key_of(const Words& words) {
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t)};
}

/// Reads words one after another; whoever reads behind their end knows it by `is_short`.
struct WordReader {
  const Words& words;
  std::size_t next = 0;
  bool is_short = false;

  std::uint32_t take() {
    is_short = is_short || next == words.size();
    return is_short ? 0 : words[next++];
  }
  /// A number of things of which each takes a word at least.
  std::uint32_t take_number() {
    const std::uint32_t number = take();
    is_short = is_short || number > words.size() - next;
    return is_short ? 0 : number;
  }
};

/// False when there is no such leg.
bool read_leg(WordReader& reader, PixelLeg& leg) {
  const std::uint32_t what = reader.take();
  const std::uint32_t handed = reader.take();
  const std::uint32_t stage = what & k_byte_mask;
  const std::uint32_t ray = what >> k_byte & k_byte_mask;
  const std::uint32_t primitive = what >> (2 * k_byte);
  leg = {static_cast<models::Stage>(stage),
         static_cast<firmware::RayKind>(ray),
         static_cast<std::uint8_t>(primitive),
         static_cast<std::uint16_t>(handed & k_half_mask),
         static_cast<std::uint16_t>(handed >> k_half),
         {}};
  std::uint32_t end = 0;
  for (std::uint32_t left = reader.take_number(); left > 0; --left) {
    const std::uint32_t operation = reader.take();
    const std::uint32_t count = reader.take();
    if (operation < end || operation >= firmware::k_operation_count || count == 0) {
      return false;
    }
    leg.work.counts[operation] = count;
    end = operation + 1;
  }
  return stage < models::k_stage_count && ray < firmware::k_ray_kind_count &&
         primitive < static_cast<std::uint32_t>(firmware::k_primitive_kind_count);
}

/// A number of places, each of one of so many things; false when one is none.
bool read_places(WordReader& reader, std::size_t things, Words& places) {
  places.resize(reader.take_number());
  for (std::uint32_t& place : places) {
    place = reader.take();
    if (place >= things) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::uint32_t LegTable::place_of(const PixelLeg& leg) {
  Words words;
  sim::append(leg, words);
  const auto [found, is_new] =
      leg_places_.try_emplace(key_of(words), static_cast<std::uint32_t>(legs_.size()));
  if (is_new) {
    legs_.push_back(leg);
  }
  return found->second;
}

std::uint32_t DistinctLists::place_of(const Words& list) {
  const auto [found, is_new] =
      places_.try_emplace(key_of(list), static_cast<std::uint32_t>(lists.size()));
  if (is_new) {
    lists.push_back(list);
  }
  return found->second;
}

void LegTable::put(const std::vector<PixelLeg>& legs) {
  Words chain;
  Words run;
  for (const PixelLeg& leg : legs) {
    run.push_back(place_of(leg));
    if (leg.stage == models::Stage::photometry) {
      chain.push_back(runs_.place_of(run));
      run.clear();
    }
  }
  chain.push_back(runs_.place_of(run));
  chain_of_pixel_.push_back(chains_.place_of(chain));
}

namespace {

/// The places in `to` of lists of what has other places there.
Words places_in(DistinctLists& to, const DistinctLists& from, const Words& other_places) {
  Words places;
  for (Words list : from.lists) {
    std::transform(list.begin(), list.end(), list.begin(),
                   [&](std::uint32_t place) { return other_places[place]; });
    places.push_back(to.place_of(list));
  }
  return places;
}

void append(const Words& list, Words& words) {
  words.push_back(static_cast<std::uint32_t>(list.size()));
  words.insert(words.end(), list.begin(), list.end());
}

void append(const DistinctLists& lists, Words& words) {
  words.push_back(static_cast<std::uint32_t>(lists.lists.size()));
  for (const Words& list : lists.lists) {
    append(list, words);
  }
}

/// False when one of them has a place that is none of so many things.
bool read_lists(WordReader& reader, std::size_t things, DistinctLists& lists) {
  lists.lists.resize(reader.take_number());
  return std::all_of(lists.lists.begin(), lists.lists.end(),
                     [&](Words& list) { return read_places(reader, things, list); });
}

}  // namespace

void LegTable::append(const LegTable& other) {
  Words leg_places;
  for (const PixelLeg& leg : other.legs_) {
    leg_places.push_back(place_of(leg));
  }
  const Words run_places = places_in(runs_, other.runs_, leg_places);
  const Words chain_places = places_in(chains_, other.chains_, run_places);
  for (const std::uint32_t chain : other.chain_of_pixel_) {
    chain_of_pixel_.push_back(chain_places[chain]);
  }
}

std::vector<PixelLeg> LegTable::legs(std::size_t pixel) const {
  std::vector<PixelLeg> legs;
  for (const std::uint32_t run : chains_.lists[chain_of_pixel_[pixel]]) {
    for (const std::uint32_t leg : runs_.lists[run]) {
      legs.push_back(legs_[leg]);
    }
  }
  return legs;
}

Words LegTable::words() const {
  Words words{static_cast<std::uint32_t>(legs_.size())};
  for (const PixelLeg& leg : legs_) {
    sim::append(leg, words);
  }
  sim::append(runs_, words);
  sim::append(chains_, words);
  sim::append(chain_of_pixel_, words);
  return words;
}

std::string LegTable::read(const Words& words) {
  WordReader reader{words};
  legs_.resize(reader.take_number());
  for (PixelLeg& leg : legs_) {
    if (!read_leg(reader, leg)) {
      return "has a leg that no pixel can have";
    }
  }
  if (!read_lists(reader, legs_.size(), runs_) ||
      !read_lists(reader, runs_.lists.size(), chains_)) {
    return "has a pixel with a leg that is not there";
  }
  if (!read_places(reader, chains_.lists.size(), chain_of_pixel_)) {
    return "has a pixel whose legs are not there";
  }
  return reader.is_short || reader.next != words.size() ? "has not as many legs as it says" : "";
}

}  // namespace maquette::sim
