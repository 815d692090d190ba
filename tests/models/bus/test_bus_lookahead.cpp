#include "models/bus/bus_lookahead.hpp"

#include <functional>
#include <systemc>

#include "tests/catch.hpp"

namespace {

using namespace maquette::models;

constexpr Instant k_now{1000};
constexpr Instant k_ahead{5000};

BusLookahead two_masters() {
  BusLookahead lookahead;
  lookahead.add_master("first");
  lookahead.add_master("second");
  return lookahead;
}

bool is_misuse(const std::function<void()>& use) {
  try {
    use();
  } catch (const sc_core::sc_report&) {
    return true;
  }
  return false;
}

TEST_CASE("while a master computes, only the kernel's past is decided") {
  BusLookahead lookahead = two_masters();
  lookahead.post(0, k_ahead, k_now);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) == k_ahead + k_tick);
  CHECK(lookahead.decidable_from(k_now, true, k_now) == k_now + k_tick);
  CHECK(lookahead.decidable_from(k_now - k_tick, true, k_now) <= k_now);
  CHECK(lookahead.decidable_from(k_ahead, false, k_now) <= k_now);
}

TEST_CASE("when all stand with a request or have retired, the bus goes ahead to its horizon") {
  BusLookahead lookahead = two_masters();
  lookahead.post(0, k_ahead, k_now);
  lookahead.retire(1, k_now);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) <= k_now);
  const Instant beyond = k_now + std::chrono::seconds(1);
  CHECK(lookahead.decidable_from(beyond - k_tick, true, k_now) <= k_now);
  CHECK(lookahead.decidable_from(beyond, true, k_now) == beyond);
}

TEST_CASE("a master that has promised needs no wake-up, and is held to its instant") {
  BusLookahead lookahead = two_masters();
  lookahead.post(0, k_now, k_now);
  lookahead.post(1, k_ahead, k_now);
  lookahead.end(0, k_ahead, true);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) == k_never);
  CHECK(is_misuse([&] { lookahead.post(0, k_ahead, k_now); }));
  CHECK(is_misuse([&] { lookahead.retire(0, k_ahead + k_tick); }));
  CHECK_FALSE(is_misuse([&] { lookahead.post(0, k_ahead, k_ahead); }));
  CHECK(lookahead.decidable_from(k_ahead, true, k_ahead) <= k_ahead);
}

TEST_CASE("up to what is promised or expected nothing unknown comes") {
  BusLookahead lookahead = two_masters();
  const int bystander = lookahead.add_bystander();
  lookahead.post(0, k_ahead, k_now);
  lookahead.promise(1, k_ahead + k_tick, k_now);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) <= k_now);
  CHECK(lookahead.decidable_from(k_ahead + k_tick, true, k_now) == k_never);
  CHECK(lookahead.known_until(k_now) == k_ahead + k_tick);
  lookahead.expect(bystander, k_ahead);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) == k_never);
  CHECK(lookahead.decidable_from(k_ahead - k_tick, true, k_now) <= k_now);
  lookahead.expect(bystander, k_never);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) <= k_now);
  CHECK(is_misuse([&] { lookahead.promise(1, k_ahead, k_now); }));
  lookahead.promise(1, k_ahead + 2 * k_tick, k_ahead + k_tick);
  CHECK(lookahead.known_until(k_ahead + k_tick) == k_ahead + 2 * k_tick);
}

TEST_CASE("a master that rests is not waited for until it is stirred") {
  BusLookahead lookahead = two_masters();
  lookahead.post(0, k_ahead, k_now);
  lookahead.rest(1, k_now);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) <= k_now);
  CHECK(is_misuse([&] { lookahead.post(1, k_now, k_now); }));
  lookahead.stir(0, k_now);  // it does not rest
  lookahead.stir(1, k_now);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) == k_never);
  lookahead.rest(1, k_now);
  lookahead.rest(1, k_ahead);
  lookahead.stir(1, k_ahead);
  CHECK_FALSE(is_misuse([&] { lookahead.post(1, k_ahead, k_ahead); }));
}

TEST_CASE("without its promise a master may post at any instant") {
  BusLookahead lookahead = two_masters();
  lookahead.post(0, k_now, k_now);
  lookahead.retire(1, k_now);
  lookahead.end(0, k_ahead, false);
  CHECK(lookahead.decidable_from(k_ahead, true, k_now) == k_ahead + k_tick);
  CHECK_FALSE(is_misuse([&] { lookahead.post(0, k_ahead, k_ahead + k_tick); }));
}

TEST_CASE("what the drawing of a master does not have is misuse") {
  BusLookahead lookahead = two_masters();
  CHECK(is_misuse([&] { lookahead.activate(0, k_now); }));
  lookahead.post(0, k_ahead, k_now);
  CHECK(is_misuse([&] { lookahead.post(0, k_ahead, k_now); }));
  CHECK(is_misuse([&] { lookahead.retire(0, k_now); }));
  lookahead.retire(1, k_now);
  CHECK(is_misuse([&] { lookahead.retire(1, k_now); }));
  lookahead.decide(k_ahead);
  CHECK(is_misuse([&] { lookahead.activate(1, k_ahead); }));
  CHECK_FALSE(is_misuse([&] { lookahead.activate(1, k_ahead + k_tick); }));
  CHECK(lookahead.standing_request(0) == k_ahead);
  CHECK_FALSE(lookahead.standing_request(1));
}

}  // namespace
