#include "sim/stability/machine_case.hpp"

#include "sim/stability/counted_transfers.hpp"
#include "sim/stability/crowded_machines.hpp"
#include "sim/stability/stiff_machines.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

void check(const std::vector<StabilityRow>& rows) {
  CHECK_FALSE(rows.empty());
  for (const StabilityRow& row : rows) {
    CAPTURE(row.subject, row.counted, row.value);
    CHECK(row.group == "machines");
    CHECK(row.bound);
    CHECK(row.holds());
  }
}

double sum_of(const std::vector<StabilityRow>& rows) {
  double sum = 0;
  for (const StabilityRow& row : rows) {
    sum += row.value;
  }
  return sum;
}

MachineCase plain_case() {
  return {"plain", trial_machine(3, {1, 2, 6, 5}), {}, {}, models::k_nobody, ""};
}

TEST_CASE("Stiff machines and frames of days keep their closed forms") {
  check(machine_case_rows(stiff_machines()));
}

TEST_CASE("Crowded machines lose neither pixels nor ticks") {
  check(machine_case_rows(crowded_machines()));
}

TEST_CASE("A video reader that takes every slot is refused with the boards that starve") {
  check(machine_case_rows(watched_machines()));
}

TEST_CASE("Machines that never end say which board and why") {
  check(machine_case_rows(endless_machines()));
  check(machine_case_rows(starving_machines()));
}

TEST_CASE("Ten million transfers lose no tick") { check(counted_transfer_rows(10'000'000)); }

TEST_CASE("What does not hold is counted") {
  MachineCase late = plain_case();
  late.frame_time = models::Duration{1};
  CHECK(sum_of(machine_case_rows({late})) > 1);
  MachineCase unnamed = plain_case();
  unnamed.longest_wait = models::Duration::zero();
  CHECK(sum_of(machine_case_rows({unnamed})) > 1);
  MachineCase refused = plain_case();
  refused.trial.machine.parameters.board.ram_bytes = 0;
  CHECK(sum_of(machine_case_rows({refused})) > 0);
  MachineCase accepted = plain_case();
  accepted.refusal = "board";
  CHECK(sum_of(machine_case_rows({accepted})) == 1);
}

TEST_CASE("A trial that hangs ends with its processor time") {
  TrialMachine trial = plain_case().trial;
  trial.work = [](std::int64_t) -> std::uint32_t {
    for (volatile std::uint32_t forever = 0;;) {
      forever = forever + 1;
    }
  };
  const std::vector<TrialOutcome> outcomes = run_trials({trial}, 1);
  CHECK_FALSE(outcomes.front().has_finished);
  CHECK_THAT(std::string(outcomes.front().message),
             Catch::Matchers::ContainsSubstring("ended by signal"));
}

}  // namespace
}  // namespace maquette::sim
