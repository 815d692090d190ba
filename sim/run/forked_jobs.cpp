#include "sim/run/forked_jobs.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>
#include <stdexcept>

#include "sim/run/interruption.hpp"

namespace maquette::sim {

namespace {

/// Lets signals end a wait for children instead of starting it again.
void let_signals_interrupt() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    action.sa_flags &= ~SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

sigset_t ending_signals() {
  sigset_t signals{};
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

JobEnd end_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return {128 + signal, fmt::format("ended by signal {} ({})", signal, strsignal(signal))};
  }
  return {WEXITSTATUS(status), ""};
}

/// Lets this process end when its parent does, even if that is killed.
void end_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) {
    ::_exit(128 + SIGTERM);  // it has ended already
  }
}

class Pool {
 public:
  explicit Pool(const ForkedJobs& jobs) : jobs_(jobs) {}

  /// Nobody is left behind when an end cannot be told, such as on a full disk.
  bool run() {
    try {
      return run_all();
    } catch (...) {
      end_all([](std::size_t /*job*/, const JobEnd& /*end*/) {});
      throw;
    }
  }

 private:
  bool run_all() {
    let_signals_interrupt();
    std::size_t next = 0;
    while (next < jobs_.count || !running_.empty()) {
      const bool has_room = running_.size() < static_cast<std::size_t>(jobs_.processes);
      if (Interruption::is_requested()) {
        end_all(jobs_.ended);
        return false;
      }
      if (next < jobs_.count && has_room) {
        start(next++);
      } else {
        wait_for_one(jobs_.ended);
      }
    }
    return true;
  }

  void start(std::size_t job) {
    // A signal to the child waits until it has given up the parent's handlers.
    sigset_t before{};
    const sigset_t ending = ending_signals();
    ::sigprocmask(SIG_BLOCK, &ending, &before);
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
      end_with(parent);
      ::sigprocmask(SIG_SETMASK, &before, nullptr);
      ::_exit(jobs_.run(job));  // what the parent holds is not ours to destroy
    }
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    if (process < 0) {
      throw std::runtime_error(fmt::format("no process can be made: {}", std::strerror(errno)));
    }
    running_.emplace(process, job);
  }

  template <class Ended>
  void wait_for_one(const Ended& ended) {
    int status = 0;
    const pid_t process = ::waitpid(-1, &status, 0);
    const auto found = running_.find(process);
    if (found == running_.end()) {
      return;  // a signal came
    }
    const std::size_t job = found->second;
    running_.erase(found);
    const JobEnd end = end_of(status);
    if (end.exit_code == 0 || !Interruption::is_requested()) {
      ended(job, end);
    }
  }

  template <class Ended>
  void end_all(const Ended& ended) {
    for (const auto& [process, job] : running_) {
      ::kill(process, SIGTERM);
    }
    while (!running_.empty()) {
      wait_for_one(ended);
    }
  }

  const ForkedJobs& jobs_;
  std::map<pid_t, std::size_t> running_;
};

}  // namespace

bool run_forked(const ForkedJobs& jobs) { return Pool(jobs).run(); }

}  // namespace maquette::sim
