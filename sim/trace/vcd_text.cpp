#include "sim/trace/vcd_text.hpp"

#include <algorithm>

namespace maquette::sim {

namespace {

// A variable's short name in the file: its number with the digits '!' to '~'.
std::string identifier_of(std::size_t number) {
  constexpr std::size_t k_digits = '~' - '!' + 1;
  std::string text;
  do {
    text += static_cast<char>('!' + number % k_digits);
    number /= k_digits;
  } while (number > 0);
  return text;
}

}  // namespace

std::size_t VcdText::add(const VcdVariable& variable) {
  states_.push_back({variable, identifier_of(states_.size()), {}, {}});
  return states_.size() - 1;
}

void VcdText::declare(std::string_view comment) {
  text_.add("$comment\n{}$end\n$version maquette $end\n$timescale 1 ps $end\n", comment);
  std::string scope;
  for (const State& state : states_) {
    const VcdVariable& variable = state.variable;
    if (variable.scope != scope) {
      text_.add("{}$scope module {} $end\n", scope.empty() ? "" : "$upscope $end\n",
                variable.scope);
      scope = variable.scope;
    }
    text_.add("$var wire {} {} {}{} $end\n", variable.bits, state.identifier, variable.name,
              variable.bits > 1 ? fmt::format(" [{}:0]", variable.bits - 1) : "");
  }
  text_.add("{}$enddefinitions $end\n", scope.empty() ? "" : "$upscope $end\n");
}

void VcdText::set(std::size_t variable, std::optional<std::uint64_t> value) {
  State& state = states_[variable];
  state.value = value;
  if (!state.is_touched) {
    state.is_touched = true;
    touched_.push_back(variable);
  }
}

void VcdText::show_all(models::Instant at) {
  stamp(at);
  text_.add("$dumpvars\n");
  for (State& state : states_) {
    show(state);
  }
  text_.add("$end\n");
  forget_touched();
}

void VcdText::show_changes(models::Instant at) {
  bool is_stamped = false;
  std::sort(touched_.begin(), touched_.end());
  for (const std::size_t variable : touched_) {
    State& state = states_[variable];
    if (state.value != state.shown) {
      if (!is_stamped) {
        stamp(at);
        is_stamped = true;
      }
      show(state);
    }
  }
  forget_touched();
}

void VcdText::show(State& state) {
  const std::string value = state.value ? fmt::format("{:b}", *state.value) : "z";
  if (state.variable.bits == 1) {
    text_.add("{}{}\n", value, state.identifier);
  } else {
    text_.add("b{} {}\n", value, state.identifier);
  }
  state.shown = state.value;
}

void VcdText::forget_touched() {
  for (const std::size_t variable : touched_) {
    states_[variable].is_touched = false;
  }
  touched_.clear();
}

}  // namespace maquette::sim
