#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <map>
#include <set>
#include <stdexcept>

#include "sim/run/forked_jobs.hpp"
#include "sim/run/interruption.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;

TEST_CASE("every job runs once in a process of its own and its end is told") {
  const Interruption interruption;
  int touched = 0;
  std::map<std::size_t, JobEnd> ends;
  ForkedJobs jobs;
  jobs.count = 20;
  jobs.processes = 3;
  jobs.run = [&touched](std::size_t job) {
    ++touched;
    if (job == 7) {
      std::signal(SIGSEGV, SIG_DFL);
      std::raise(SIGSEGV);
    }
    return touched == 1 ? static_cast<int>(job % 5) : 99;
  };
  jobs.ended = [&ends](std::size_t job, const JobEnd& end) {
    CHECK(ends.emplace(job, end).second);
  };
  CHECK(run_forked(jobs));
  CHECK(touched == 0);
  REQUIRE(ends.size() == 20);
  for (const auto& [job, end] : ends) {
    INFO(job);
    CHECK(end.exit_code == (job == 7 ? 128 + SIGSEGV : static_cast<int>(job % 5)));
    CHECK(end.crash.empty() == (job != 7));
  }
}

TEST_CASE("an interruption ends the running jobs and starts no other") {
  const Interruption interruption;
  std::set<std::size_t> ended;
  ForkedJobs jobs;
  jobs.count = 10;
  jobs.processes = 2;
  jobs.run = [](std::size_t job) {
    if (job >= 2) {
      ::pause();
    }
    return 0;
  };
  jobs.ended = [&ended](std::size_t job, const JobEnd&) {
    ended.insert(job);
    if (ended.size() == 2) {
      std::raise(SIGINT);
    }
  };
  CHECK_FALSE(run_forked(jobs));
  CHECK(ended == std::set<std::size_t>{0, 1});
}

TEST_CASE("an end that cannot be told ends the other jobs too") {
  const Interruption interruption;
  ForkedJobs jobs;
  jobs.count = 4;
  jobs.processes = 3;
  jobs.run = [](std::size_t job) {
    if (job > 0) {
      ::pause();
    }
    return 0;
  };
  jobs.ended = [](std::size_t, const JobEnd&) { throw std::runtime_error("the disk is full"); };
  CHECK_THROWS_WITH(run_forked(jobs), "the disk is full");
  CHECK(::waitpid(-1, nullptr, WNOHANG) == -1);  // nobody is left
}

TEST_CASE("jobs end when their parent is killed") {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    const Interruption interruption;
    ::close(ends[0]);
    ForkedJobs jobs;
    jobs.count = 2;
    jobs.processes = 2;
    jobs.run = [&ends](std::size_t) {
      const char started = 's';
      static_cast<void>(::write(ends[1], &started, 1));
      ::pause();
      return 0;
    };
    jobs.ended = [](std::size_t, const JobEnd&) {};
    static_cast<void>(run_forked(jobs));
    ::_exit(0);
  }
  ::close(ends[1]);
  char started = 0;
  REQUIRE(::read(ends[0], &started, 1) == 1);
  REQUIRE(::read(ends[0], &started, 1) == 1);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  // The pipe ends when the last of those that can write into it does.
  CHECK(::read(ends[0], &started, 1) == 0);
  ::close(ends[0]);
}
