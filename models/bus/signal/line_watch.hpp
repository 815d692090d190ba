#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <systemc>
#include <utility>
#include <vector>

#include "models/bus/line_state.hpp"
#include "models/bus/signal/bus_lines.hpp"

namespace maquette::models {

/// Shows an observer the lines of a backplane: each as it is when it is added, and then at every
/// change, delta by delta.
class LineWatch {
 public:
  explicit LineWatch(LineObserver observer) : observer_(std::move(observer)) {}

  /// Adds the lines that all boards share, with a word of so many bits, within the module under
  /// construction; they are kept by reference.
  void add(const BusLines& lines, int word_bits);

  /// Adds a line likewise.
  void add(const std::string& name, const BusLine& line);

 private:
  class Process : public sc_core::sc_module {
   public:
    Process(const sc_core::sc_module_name& name, const sc_core::sc_event& change,
            std::function<void()> show);

   private:
    void run() { show_(); }

    std::function<void()> show_;
  };

  void add(const std::string& name, int bits, const sc_core::sc_event& change,
           const std::function<std::uint64_t()>& value);

  LineObserver observer_;
  std::vector<std::unique_ptr<Process>> processes_;  // by line
};

}  // namespace maquette::models
