#include "sim/trace/vcd_changes.hpp"

#include <cstdint>
#include <random>
#include <vector>

#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

using models::Instant;

/// A piece of what a source tells: from an instant on, changes at and after it.
struct Piece {
  Instant from;
  std::vector<Instant> changes;
};

/// Pieces in the order of their begin, whose changes reach beyond those of the next ones.
std::vector<Piece> random_pieces(std::mt19937& random) {
  std::vector<Piece> pieces(random() % 40);
  Instant now{};
  for (Piece& piece : pieces) {
    now += models::Duration(random() % 4);
    piece.from = now;
    for (auto left = random() % 4; left > 0; --left) {
      piece.changes.push_back(now + models::Duration(random() % 50));
    }
  }
  return pieces;
}

}  // namespace

TEST_CASE("Changes of many sources come in the order of time, and none is lost") {
  std::mt19937 random(1064);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::vector<Piece>> all(1 + random() % 6);
    VcdDump dump;
    std::vector<ChangeSource> sources;
    std::size_t expected = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = random_pieces(random);
      for (const Piece& piece : all[i]) {
        expected += piece.changes.size();
      }
      sources.push_back(source_of(all[i], [&dump, i](const Piece& piece) {
        for (const Instant at : piece.changes) {
          dump.set(static_cast<std::uint16_t>(i), at, 0);
        }
      }));
    }
    ChangesInOrder changes(dump, std::move(sources));
    Instant now{};
    std::uint64_t number = 0;
    std::size_t taken = 0;
    for (; changes.has_before(models::k_never); ++taken) {
      const bool is_now = changes.has_at_most(now);
      const SignalChange change = changes.take();
      REQUIRE(change.at >= now);
      REQUIRE(is_now == (change.at == now));
      if (is_now && taken > 0) {
        REQUIRE(change.number > number);
      }
      now = change.at;
      number = change.number;
    }
    CHECK(taken == expected);
  }
}

TEST_CASE("What is told early is held no longer than until its time") {
  VcdDump dump;
  const std::vector<Piece> pieces{{Instant(5), {Instant(9), Instant(5)}},
                                  {Instant(7), {Instant(7)}}};
  ChangesInOrder changes(dump, {source_of(pieces, [&dump](const Piece& piece) {
                           for (const Instant at : piece.changes) {
                             dump.set(0, at, 1);
                           }
                         })});
  CHECK_FALSE(changes.has_before(Instant(5)));
  CHECK(changes.has_at_most(Instant(5)));
  CHECK(changes.take().at == Instant(5));
  CHECK(changes.take().at == Instant(7));
  CHECK(changes.take().at == Instant(9));
  CHECK_FALSE(changes.has_before(models::k_never));
}

}  // namespace maquette::sim
