#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "models/bus/instant.hpp"
#include "sim/trace/trace_text.hpp"

namespace maquette::sim {

/// A variable of a value change dump: of one bit, or a vector of more.
struct VcdVariable {
  std::string scope;
  std::string name;
  int bits;
};

/// A value change dump (IEEE 1364, chapter 18) with a resolution of 1 ps on its way to a stream:
/// declarations, then all values at the first instant, then what changes at later ones. A variable
/// floats until it is set.
class VcdText {
 public:
  explicit VcdText(std::ostream& stream) : text_(stream) {}

  /// Adds a variable, before the declarations; those of a scope come one after the other. Returns
  /// its number.
  std::size_t add(const VcdVariable& variable);

  /// Writes the declarations after a comment about the whole.
  void declare(std::string_view comment);

  /// The value of a variable from the next instant on that is shown; nothing: it floats.
  void set(std::size_t variable, std::optional<std::uint64_t> value);

  /// Writes all values.
  void show_all(models::Instant at);

  /// Writes what is not as it was shown before; nothing if all is.
  void show_changes(models::Instant at);

  /// Writes the last instant, alone.
  void end(models::Instant at) {
    stamp(at);
    text_.flush();
  }

 private:
  struct State {
    VcdVariable variable;
    std::string identifier;
    std::optional<std::uint64_t> value;
    std::optional<std::uint64_t> shown;
    bool is_touched = false;
  };

  void stamp(models::Instant at) { text_.add("#{}\n", at.count()); }
  void show(State& state);
  void forget_touched();

  std::vector<State> states_;
  std::vector<std::size_t> touched_;
  TraceText text_;
};

}  // namespace maquette::sim
