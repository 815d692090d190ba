#include "sim/run/interruption.hpp"

#include <csignal>

namespace maquette::sim {

namespace {

void request_interruption(int signal) {
  firmware::stop_requested = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  firmware::stop_requested = false;
  std::signal(SIGINT, request_interruption);
  std::signal(SIGTERM, request_interruption);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace maquette::sim
