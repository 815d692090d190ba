#include "models/bus/signal/line_monitor.hpp"

namespace maquette::models {

bool LineMonitor::decide(int master, Instant now) {
  const Contenders standing = requests_.up_to(now);
  account_.decide(now, standing);
  const bool kept = holder_ != k_nobody;
  if (kept) {  // the others wait for it between its accesses as well
    account_.occupy(holder_, free_at_, now, standing);
    account_.keep(holder_, now - free_at_);
  }
  requests_.remove(master);
  return kept;
}

void LineMonitor::release(int master, Instant decision, Instant now, bool keeps) {
  account_.occupy(master, decision, now, requests_.up_to(now));
  free_at_ = now;
  holder_ = keeps ? master : k_nobody;
}

}  // namespace maquette::models
