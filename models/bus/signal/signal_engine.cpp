#include "models/bus/signal/signal_engine.hpp"

#include <algorithm>
#include <string>

namespace maquette::models {

namespace {

constexpr int k_bits_per_byte = 8;

// The masters of a level, the nearest to the arbiter first.
std::vector<int> chain_of(const BusMasters& masters, int level) {
  std::vector<int> chain;
  for (int master = 0; master < masters.count(); ++master) {
    if (masters[master].place.level == level) {
      chain.push_back(master);
    }
  }
  std::sort(chain.begin(), chain.end(), [&masters](int a, int b) {
    return masters[a].place.position < masters[b].place.position;
  });
  return chain;
}

// Of a name in the kernel's hierarchy.
std::string leaf_of(const std::string& name) { return name.substr(name.rfind('.') + 1); }

}  // namespace

SignalEngine::SignalEngine(const sc_core::sc_module_name& name,
                           const VersaBusParameters& parameters, const BusParts& parts)
    : sc_module(name),
      word_bytes_(static_cast<unsigned>(parameters.data_width_bits / k_bits_per_byte)),
      monitor_(parts.account),
      arbiter_("arbiter", parameters.arbitration, lines_, settling_),
      timer_("timer", parts.slaves.timeout(), parts.slaves.address_map(), lines_),
      panel_{parts,
             lines_,
             settling_,
             monitor_,
             {Period::of_frequency(parameters.clock_hz), parameters.arbitration_clocks,
              parameters.handover_clocks},
             parameters.arbitration.chain == GrantChain::ring} {}

void SignalEngine::enter(int master, Instant request) {
  masters_[static_cast<std::size_t>(master)]->enter(request);
}

// ---- once all masters and slaves are attached ----

void SignalEngine::before_end_of_elaboration() {
  masters_.resize(static_cast<std::size_t>(panel_.parts.masters.count()));
  links_.resize(masters_.size());
  if (panel_.is_ring) {
    make_ring();
  } else {
    for (int level = 0; level < BusLines::k_levels; ++level) {
      make_chain(lines_.grant[static_cast<std::size_t>(level)],
                 chain_of(panel_.parts.masters, level));
    }
  }
  for (int slave = 0; slave < panel_.parts.slaves.address_map().count(); ++slave) {
    slaves_.push_back(std::make_unique<SlaveInterface>(("slave" + std::to_string(slave)).c_str(),
                                                       slave, word_bytes_, panel_.parts.slaves,
                                                       lines_));
  }
  if (watch_) {
    watch_lines();
  }
}

void SignalEngine::watch_lines() {
  watch_->add(lines_, static_cast<int>(k_bits_per_byte * word_bytes_));
  for (int master = 0; master < panel_.parts.masters.count(); ++master) {
    watch_->add("BGOUT_" + leaf_of(panel_.parts.masters[master].name) + "_n",
                *links_[static_cast<std::size_t>(master)]);
  }
}

BusLine& SignalEngine::make_link(int master) {
  const std::string name = "BGOUT" + std::to_string(master) + "_n";
  auto& link = links_[static_cast<std::size_t>(master)];
  link = std::make_unique<BusLine>(name.c_str(), sc_dt::SC_LOGIC_Z);
  return *link;
}

void SignalEngine::make_master(int master, const BusLine& grant, const BusLine& left,
                               BusLine& right) {
  const std::string number = std::to_string(master);
  slots_.push_back(std::make_unique<GrantSlot>(("slot" + number).c_str(), grant, left, right));
  masters_[static_cast<std::size_t>(master)] = std::make_unique<MasterInterface>(
      ("master" + number).c_str(), master, panel_, *slots_.back());
}

void SignalEngine::make_chain(const BusLine& grant, const std::vector<int>& masters) {
  const BusLine* left = &grant;
  for (const int master : masters) {
    BusLine& right = make_link(master);
    make_master(master, grant, *left, right);
    left = &right;
  }
}

// Begins as though the last master had had the bus.
void SignalEngine::make_ring() {
  const BusLine& grant = lines_.grant[0];
  const int masters = panel_.parts.masters.count();
  if (masters == 0) {
    return;
  }
  BusLine& first = make_link(masters - 1);
  const BusLine* left = &first;
  for (int master = 0; master < masters; ++master) {
    BusLine& right = master + 1 < masters ? make_link(master) : first;
    make_master(master, grant, *left, right);
    left = &right;
  }
  slots_.back()->start_ring(true);
}

}  // namespace maquette::models
