#include "models/board/mc68000/decoder_table.hpp"

#include <memory>
#include <stdexcept>

#include "tests/catch.hpp"

namespace {

using namespace maquette::models::mc68000;

TEST_CASE("an MC68000 has 45,815 instruction words") {
  unsigned legal = 0;
  for (unsigned word = 0; word < 0x10000; ++word) {
    legal += decoder_table().is_legal(static_cast<std::uint16_t>(word)) ? 1 : 0;
  }
  CHECK(legal == 45'815);
}

TEST_CASE("a word can have one meaning only") {
  const auto table = std::make_unique<DecoderTable>();
  CHECK_FALSE(table->is_legal(0x1234));
  const Handler nothing = [](ExecutionUnit& /*unit*/, unsigned /*word*/) {};
  table->set(0x1234, 3, nothing, {4, 1});
  CHECK(table->is_legal(0x1234));
  CHECK(table->is_legal(0x1237));
  CHECK_FALSE(table->is_legal(0x1238));
  CHECK_THROWS_AS(table->set(0x1236, 8, nothing, {4, 1}), std::logic_error);
}

TEST_CASE("costs are packed and unpacked") {
  const InstructionCost cost = unpacked(packed({300, 5, 33, 34}) + packed({1, 2, 3, 4}));
  CHECK(cost.cycles == 301);
  CHECK(cost.fetches == 7);
  CHECK(cost.reads == 36);
  CHECK(cost.writes == 38);
}

}  // namespace
