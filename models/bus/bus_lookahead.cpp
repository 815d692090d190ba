#include "models/bus/bus_lookahead.hpp"

#include <algorithm>

#include "models/bus/bus_misuse.hpp"

namespace maquette::models {

void BusLookahead::add_master(const std::string& name) {
  masters_.push_back({name});
  ++computing_;
}

int BusLookahead::add_bystander() {
  bystanders_.push_back(k_never);
  return static_cast<int>(bystanders_.size()) - 1;
}

void BusLookahead::post(int master, Instant request, Instant now) {
  leave(at(master), State::requesting, now);
  at(master).instant = request;
}

void BusLookahead::end(int master, Instant end, bool promised) {
  if (promised) {
    set_promised(at(master), end);
  } else {
    at(master).state = State::computing;
    ++computing_;
  }
}

void BusLookahead::promise(int master, Instant instant, Instant now) {
  leave(at(master), State::promised, now);
  set_promised(at(master), instant);
}

void BusLookahead::rest(int master, Instant now) {
  if (at(master).state != State::resting) {
    leave(at(master), State::resting, now);
  }
}

void BusLookahead::stir(int master, Instant now) {
  if (at(master).state == State::resting) {
    set_promised(at(master), now);
  }
}

void BusLookahead::expect(int bystander, Instant instant) {
  bystanders_[static_cast<std::size_t>(bystander)] = instant;
  earliest_act_.reset();
}

void BusLookahead::retire(int master, Instant now) { leave(at(master), State::retired, now); }

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

void BusLookahead::set_promised(Master& master, Instant instant) {
  master.state = State::promised;
  master.instant = instant;
  earliest_act_.reset();
}

void BusLookahead::leave(Master& master, State next, Instant now) {
  switch (master.state) {
    case State::computing:
      --computing_;
      break;
    case State::promised:
      if (master.instant != now) {
        report_misuse("master " + master.name + " broke its promise to run ahead");
      }
      earliest_act_.reset();
      break;
    case State::resting:
      report_misuse("master " + master.name + " rests until it is stirred");
      break;
    case State::requesting:
    case State::retired:
      report_misuse("master " + master.name + " is retired or has a transaction already");
      break;
  }
  master.state = next;
}

Instant BusLookahead::find_earliest_act() const {
  Instant earliest = k_never;
  for (const Master& master : masters_) {
    if (master.state == State::promised) {
      earliest = std::min(earliest, master.instant);
    }
  }
  for (const Instant instant : bystanders_) {
    earliest = std::min(earliest, instant);
  }
  return earliest;
}

std::optional<Instant> BusLookahead::standing_request(int master) const {
  const Master& one = masters_[static_cast<std::size_t>(master)];
  return one.state == State::requesting ? std::optional(one.instant) : std::nullopt;
}

}  // namespace maquette::models
