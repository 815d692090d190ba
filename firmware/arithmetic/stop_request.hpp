#pragma once

#include <atomic>

/// How the host ends work that counts or executes for long: a single pixel may take minutes.
namespace maquette::firmware {

/// Whether all work is to end. A signal handler sets it, which can reach nothing but a global.
inline std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// Thrown out of work that ends so.
struct StopRequested {};

/// A look that costs next to nothing.
inline void end_if_requested() {
  if (stop_requested.load(std::memory_order_relaxed)) {
    throw StopRequested();
  }
}

/// What `work` gives, or `otherwise` where it was asked to end: what comes next ends as well, and
/// says what there is.
template <class Result, class Work>
Result unless_stopped(Work work, Result otherwise) {
  try {
    return work();
  } catch (const StopRequested&) {
    return otherwise;
  }
}

}  // namespace maquette::firmware
