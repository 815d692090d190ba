#include "sim/run/forked_jobs.hpp"

#include <fmt/format.h>
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

class Pool {
 public:
  explicit Pool(const ForkedJobs& jobs) : jobs_(jobs) {}

  bool run() {
    let_signals_interrupt();
    std::size_t next = 0;
    while (next < jobs_.count || !running_.empty()) {
      const bool has_room = running_.size() < static_cast<std::size_t>(jobs_.processes);
      if (Interruption::is_requested()) {
        end_all();
        return false;
      }
      if (next < jobs_.count && has_room) {
        start(next++);
      } else {
        wait_for_one();
      }
    }
    return true;
  }

 private:
  void start(std::size_t job) {
    // A signal to the child waits until it has given up the parent's handlers.
    sigset_t before{};
    const sigset_t ending = ending_signals();
    ::sigprocmask(SIG_BLOCK, &ending, &before);
    const pid_t process = ::fork();
    if (process == 0) {
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
      ::sigprocmask(SIG_SETMASK, &before, nullptr);
      ::_exit(jobs_.run(job));  // what the parent holds is not ours to destroy
    }
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    if (process < 0) {
      throw std::runtime_error(fmt::format("no process can be made: {}", std::strerror(errno)));
    }
    running_.emplace(process, job);
  }

  void wait_for_one() {
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
      jobs_.ended(job, end);
    }
  }

  void end_all() {
    for (const auto& [process, job] : running_) {
      ::kill(process, SIGTERM);
    }
    while (!running_.empty()) {
      wait_for_one();
    }
  }

  const ForkedJobs& jobs_;
  std::map<pid_t, std::size_t> running_;
};

}  // namespace

bool run_forked(const ForkedJobs& jobs) { return Pool(jobs).run(); }

}  // namespace maquette::sim
