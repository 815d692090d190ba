#include "sim/database/database_image.hpp"

#include <set>

#include "firmware/memory_needs.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

/// Of a database that holds nothing but its needs.
std::vector<unsigned char> image_of(const firmware::Needs& needs) {
  firmware::Database<float> database{};
  database.needs = needs;
  return database_image(database);
}

}  // namespace

TEST_CASE("The image of a database is as long as its bytes are counted") {
  firmware::Database<float> database{};
  CHECK(static_cast<std::int64_t>(database_image(database).size()) ==
        firmware::database_bytes(database));
}

TEST_CASE("Every need that a board is told has a bit of its own") {
  using firmware::Needs;
  std::set<std::vector<unsigned char>> images{image_of(Needs{})};
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    Needs needs{};
    needs.primitives[kind] = true;
    images.insert(image_of(needs));
  }
  for (int distribution = 0; distribution < 3; ++distribution) {
    Needs needs{};
    needs.facets[distribution] = true;
    images.insert(image_of(needs));
  }
  for (bool Needs::*need :
       {&Needs::unions, &Needs::large_unions, &Needs::intersections, &Needs::differences,
        &Needs::diffuse, &Needs::specular, &Needs::dielectrics, &Needs::metals,
        &Needs::transparency, &Needs::absorption, &Needs::lights, &Needs::shadows, &Needs::ambient,
        &Needs::reflections, &Needs::depth}) {
    Needs needs{};
    needs.*need = true;
    images.insert(image_of(needs));
  }
  CHECK(images.size() == 1 + firmware::k_primitive_kind_count + firmware::k_further_need_bits);
}

}  // namespace maquette::sim
