#include "tools/benchmark/child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

namespace maquette::benchmark {

namespace {

[[noreturn]] void become(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nothing, STDOUT_FILENO);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

ProcessUsage run_process(const std::vector<std::string>& command) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error("no process for " + command.front());
  }
  if (child == 0) {
    become(command);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error(command.front() + " failed");
  }
  constexpr double k_kibibyte = 1024;
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), seconds(usage.ru_utime),
          std::chrono::duration<double>(Clock::now() - start).count(),
          static_cast<double>(usage.ru_maxrss) * k_kibibyte};
}

}  // namespace maquette::benchmark
