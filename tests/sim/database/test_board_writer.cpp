#include "sim/database/board_writer.hpp"

#include <stdexcept>

#include "tests/catch.hpp"

using namespace maquette;

namespace {

using Bytes = std::vector<unsigned char>;

template <class Structure>
void check_size() {
  Bytes ram(4096);
  sim::BoardWriter writer(ram, firmware::NumberFormat::ieee_single);
  const Structure structure{};
  CHECK(writer.write(64, &structure, 1) - 64 == firmware::board_bytes<Structure>());
  CHECK(writer.write(64, &structure, 1) % 2 == 0);
}

TEST_CASE("structures take on a board what the layout tells") {
  check_size<firmware::Leaf<float>>();
  check_size<firmware::Composite>();
  check_size<firmware::Surface<float>>();
  check_size<firmware::Light<float>>();
  check_size<firmware::Database<float>>();
  check_size<firmware::Extent<float>>();
  check_size<firmware::PreparedLeaf<float>>();
  check_size<firmware::Prepared<float>>();
  check_size<firmware::Crossing<float>>();
  check_size<firmware::PendingRay<float>>();
  CHECK(firmware::board_bytes<firmware::Leaf<float>>() == 108);
  CHECK(firmware::board_bytes<firmware::Composite>() == 14);
  CHECK(firmware::board_bytes<firmware::Crossing<float>>() == 12);
  CHECK(firmware::board_bytes<firmware::PendingRay<float>>() == 44);
}

TEST_CASE("fields follow one another big-endian, words on even addresses") {
  Bytes ram(16);
  sim::BoardWriter writer(ram, firmware::NumberFormat::ieee_single);
  const firmware::Crossing<float> crossing{1, 0x01020304, 5, true, 0x0607};
  CHECK(writer.write(2, &crossing, 1) == 14);
  CHECK(ram == Bytes{0, 0, 0x3F, 0x80, 0, 0, 1, 2, 3, 4, 5, 1, 6, 7, 0, 0});
  const firmware::Composite composite{1, {2, 3}, firmware::BooleanOperator::difference};
  CHECK(writer.write(0, &composite, 1) == 14);
  CHECK(ram == Bytes{0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 2, 0x07, 0, 0});
}

TEST_CASE("numbers are in the format of the board's program") {
  const float number = -1;
  Bytes ram(4);
  sim::BoardWriter(ram, firmware::NumberFormat::ffp).write(0, &number, 1);
  CHECK(ram == Bytes{0x80, 0, 0, 0xC1});
  sim::BoardWriter(ram, firmware::NumberFormat::ieee_single).write(0, &number, 1);
  CHECK(ram == Bytes{0xBF, 0x80, 0, 0});
}

TEST_CASE("pointers become the addresses of what they point to") {
  Bytes ram(16);
  sim::BoardWriter writer(ram, firmware::NumberFormat::ffp);
  firmware::Crossing<float> crossings[2];
  const firmware::WorkArea<float> area{crossings, nullptr};
  CHECK_THROWS_AS(writer.write(0, &area, 1), std::out_of_range);
  writer.tell(crossings, 0x00123456);
  writer.write(0, &area, 1);
  CHECK(Bytes(ram.begin(), ram.begin() + 8) == Bytes{0, 0x12, 0x34, 0x56, 0, 0, 0, 0});
}

TEST_CASE("nothing is written behind the RAM") {
  Bytes ram(12);
  sim::BoardWriter writer(ram, firmware::NumberFormat::ffp);
  const firmware::Composite composite{};
  CHECK_THROWS_AS(writer.write(0, &composite, 1), std::out_of_range);
}

}  // namespace
