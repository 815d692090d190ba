#include <algorithm>

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/versabus.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

struct Script {
  BusMasterPlace place;
  std::vector<Step> steps;
};

// Few distinct times, so that many requests and ends fall on the same tick, and some that do not.
Duration random_time(std::mt19937& generator) {
  const int kind = below(generator, 4);
  if (kind == 0) {
    return Duration::zero();
  }
  return kind == 1 ? Duration{below(generator, 5'000'000)}
                   : Duration{125'000LL * below(generator, 40)};
}

std::vector<Script> random_scripts(std::mt19937& generator) {
  std::vector<Script> scripts;
  const int masters = 1 + below(generator, 6);
  for (int master = 0; master < masters; ++master) {
    Script script{{below(generator, 3), master}, {}};
    const int steps = below(generator, 60);
    for (int step = 0; step < steps; ++step) {
      script.steps.push_back({random_time(generator), 0x1000, 1 + below(generator, 4),
                              random_time(generator), below(generator, 2) == 1});
    }
    scripts.push_back(std::move(script));
  }
  return scripts;
}

// A slave that is slower in some spans of time, so that a wrong strobe shows.
Duration uneven(Instant strobe) { return Duration{50'000 + strobe.count() / 1'000 % 700'000}; }

// The law of the bus, written down with all scripts in sight and no kernel.
class Oracle {
 public:
  Oracle(const std::vector<Script>& scripts, const VersaBusParameters& parameters)
      : parameters_(parameters) {
    for (const Script& script : scripts) {
      queues_.push_back({script, 0, 0, script.steps.empty() ? k_never : script.steps[0].compute});
    }
  }

  std::vector<BusAccess> run() {
    for (Instant start = earliest(); start != k_never; start = earliest()) {
      start = std::max(start, free_at_);
      const bool keeps = holder_ >= 0 && !cleared(start);
      const int winner = keeps ? holder_ : choose_at(keeps_or_released(start));
      const Instant arbitrated = keeps ? queue(winner).request : released_at_;
      const Clocks clocks =
          keeps ? 0
                : parameters_.arbitration_clocks +
                      (previous_ >= 0 && previous_ != winner ? parameters_.handover_clocks : 0);
      grant(winner, arbitrated + Duration{125'000} * clocks);
    }
    return log_;
  }

 private:
  struct Queue {
    Script script;
    std::size_t step;
    int access;
    Instant request;
  };

  Queue& queue(int master) { return queues_[static_cast<std::size_t>(master)]; }

  Instant earliest() const {
    Instant first = k_never;
    for (const Queue& queue : queues_) {
      first = std::min(first, queue.request);
    }
    return first;
  }

  bool cleared(Instant /*start*/) {
    if (!parameters_.arbitration.clears_bus) {
      return false;
    }
    clear_at_ = k_never;
    for (const Queue& other : queues_) {
      if (other.script.place.level > queue(holder_).script.place.level &&
          other.request <= queue(holder_).request) {
        clear_at_ = std::min(clear_at_, std::max(other.request, free_at_));
      }
    }
    return clear_at_ != k_never;
  }

  Instant keeps_or_released(Instant start) {
    released_at_ = holder_ >= 0 ? clear_at_ : start;
    return released_at_;
  }

  int choose_at(Instant instant) {
    std::vector<Contender> contenders;
    for (std::size_t master = 0; master < queues_.size(); ++master) {
      if (queues_[master].request <= instant) {
        contenders.push_back(
            {static_cast<int>(master), queues_[master].script.place, queues_[master].request});
      }
    }
    return parameters_.arbitration.choose(
        {contenders.data(), contenders.data() + contenders.size()}, previous_);
  }

  void grant(int master, Instant instant) {
    Queue& now = queue(master);
    const Step& step = now.script.steps[now.step];
    const Instant end = instant + board_access().duration(uneven(instant));
    log_.push_back({master, step.address + 2 * static_cast<unsigned>(now.access), true, now.request,
                    instant, end});
    free_at_ = end;
    previous_ = master;
    holder_ = -1;
    if (++now.access < step.accesses) {
      holder_ = step.block ? master : -1;
      now.request = end + step.gap;
      return;
    }
    now.access = 0;
    ++now.step;
    now.request =
        now.step < now.script.steps.size() ? end + now.script.steps[now.step].compute : k_never;
  }

  VersaBusParameters parameters_;
  std::vector<Queue> queues_;
  std::vector<BusAccess> log_;
  int holder_ = -1;
  int previous_ = -1;
  Instant free_at_{};
  Instant clear_at_{};
  Instant released_at_{};
};

bool same(const BusAccess& a, const BusAccess& b) {
  return a.master == b.master && a.address == b.address && a.write == b.write &&
         a.request == b.request && a.grant == b.grant && a.end == b.end;
}

TEST_CASE("looking ahead, computing unknown to the bus, and the law without a kernel agree") {
  constexpr int k_cases = 150;
  constexpr int k_styles = 5;
  std::mt19937 generator(1984);
  std::vector<std::vector<BusAccess>> expected;
  std::vector<std::vector<std::unique_ptr<Bench>>> benches(k_cases);
  for (std::size_t one = 0; one < k_cases; ++one) {
    VersaBusParameters parameters;
    parameters.arbitration = one % 2 == 0 ? k_priority : k_round_robin;
    parameters.arbitration_clocks = below(generator, 5);
    parameters.handover_clocks = below(generator, 3);
    const std::vector<Script> scripts = random_scripts(generator);
    expected.push_back(Oracle(scripts, parameters).run());
    for (int variant = 0; variant <= k_styles; ++variant) {
      const std::string name = "case" + std::to_string(one) + "_" + std::to_string(variant);
      benches[one].push_back(std::make_unique<Bench>(name, parameters, uneven));
      for (std::size_t master = 0; master < scripts.size(); ++master) {
        const int style = variant < k_styles ? variant : static_cast<int>(master) % k_styles;
        benches[one].back()->add(scripts[master].place, static_cast<Style>(style),
                                 script(scripts[master].steps));
      }
    }
  }
  sc_core::sc_start();
  for (std::size_t one = 0; one < k_cases; ++one) {
    for (std::size_t variant = 0; variant <= k_styles; ++variant) {
      const auto& log = benches[one][variant]->log;
      INFO("case " << one << " variant " << variant);
      REQUIRE(log.size() == expected[one].size());
      REQUIRE(std::equal(log.begin(), log.end(), expected[one].begin(), same));
      REQUIRE(total(benches[one][variant]->bus.statistics()).waited ==
              total(benches[one][0]->bus.statistics()).waited);
      REQUIRE(benches[one][variant]->bus.statistics().waited_for ==
              benches[one][0]->bus.statistics().waited_for);
    }
  }
}

TEST_CASE("bursts that follow one another up for seconds keep their instants") {
  std::vector<std::unique_ptr<Bench>> benches;
  for (const Style style : {Style::waiting, Style::followed_up}) {
    benches.push_back(std::make_unique<Bench>("long" + std::to_string(benches.size()),
                                              VersaBusParameters{}, uneven));
    for (int master = 0; master < 3; ++master) {
      benches.back()->add({0, master}, style,
                          repeat({Duration{(300 + master) * 1'000'000'000LL}, 0x1000, 2}, 30));
    }
  }
  sc_core::sc_start();
  const auto& waiting = benches[0]->log;
  const auto& followed_up = benches[1]->log;
  REQUIRE(waiting.size() == 180);
  CHECK(waiting.back().end > 9 * std::chrono::seconds(1));
  REQUIRE(followed_up.size() == waiting.size());
  CHECK(std::equal(waiting.begin(), waiting.end(), followed_up.begin(), same));
}

}  // namespace
