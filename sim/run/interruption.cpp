#include "sim/run/interruption.hpp"

#include <csignal>

namespace maquette::sim {

namespace {

// A signal handler can reach nothing but a global of this type.
volatile std::sig_atomic_t interruption_requested = 0;

void request_interruption(int signal) {
  interruption_requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  interruption_requested = 0;
  std::signal(SIGINT, request_interruption);
  std::signal(SIGTERM, request_interruption);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::is_requested() { return interruption_requested != 0; }

void Interruption::end_if_requested() {
  if (is_requested()) {
    throw Interrupted();
  }
}

}  // namespace maquette::sim
