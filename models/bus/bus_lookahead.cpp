#include "models/bus/bus_lookahead.hpp"

#include "models/bus/bus_misuse.hpp"

namespace maquette::models {

void BusLookahead::add_master(const std::string& name) {
  masters_.push_back({name});
  ++computing_;
}

void BusLookahead::post(int master, Instant request, Instant now) {
  leave_computing(at(master), State::requesting, now);
  at(master).instant = request;
}

void BusLookahead::end(int master, Instant end, bool promised) {
  Master& one = at(master);
  one.state = promised ? State::promised : State::computing;
  one.instant = end;
  ++(promised ? promised_ : computing_);
}

void BusLookahead::retire(int master, Instant now) {
  leave_computing(at(master), State::retired, now);
}

void BusLookahead::activate(int master, Instant now) {
  Master& one = at(master);
  if (one.state != State::retired) {
    report_misuse("only a retired master can be activated");
  }
  if (last_decision_ >= now) {
    report_misuse("the bus has run ahead of the activation of a master");
  }
  one.state = State::computing;
  ++computing_;
}

void BusLookahead::leave_computing(Master& master, State next, Instant now) {
  switch (master.state) {
    case State::computing:
      --computing_;
      break;
    case State::promised:
      if (master.instant != now) {
        report_misuse("master " + master.name + " broke its promise to run ahead");
      }
      --promised_;
      break;
    case State::requesting:
    case State::retired:
      report_misuse("master " + master.name + " is retired or has a transaction already");
      break;
  }
  master.state = next;
}

std::optional<Instant> BusLookahead::standing_request(int master) const {
  const Master& one = masters_[static_cast<std::size_t>(master)];
  return one.state == State::requesting ? std::optional(one.instant) : std::nullopt;
}

}  // namespace maquette::models
