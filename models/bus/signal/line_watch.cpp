#include "models/bus/signal/line_watch.hpp"

namespace maquette::models {

namespace {

constexpr int k_address_bits = 32;

}  // namespace

void LineWatch::add(const BusLines& lines, int word_bits) {
  for (std::size_t level = 0; level < BusLines::k_levels; ++level) {
    add("BR" + std::to_string(level) + "_n", lines.request[level]);
  }
  for (std::size_t level = 0; level < BusLines::k_levels; ++level) {
    add("BG" + std::to_string(level) + "_n", lines.grant[level]);
  }
  for (const BusLine* line :
       {&lines.busy, &lines.clear, &lines.address_strobe, &lines.upper_strobe, &lines.lower_strobe,
        &lines.write, &lines.acknowledge, &lines.error}) {
    add(line->basename(), *line);
  }
  add("address", k_address_bits, lines.address.value_changed_event(),
      [&lines] { return lines.address.read(); });
  add("data", word_bits, lines.data.value_changed_event(), [&lines] { return lines.data.read(); });
}

void LineWatch::add(const std::string& name, const BusLine& line) {
  add(name, 1, line.value_changed_event(), [&line] { return is_low(line) ? 0 : 1; });
}

void LineWatch::add(const std::string& name, int bits, const sc_core::sc_event& change,
                    const std::function<std::uint64_t()>& value) {
  const auto number = static_cast<int>(processes_.size());
  const auto show = [observer = observer_, number, name, bits, value] {
    observer({number, name, bits, value()});
  };
  show();
  processes_.push_back(
      std::make_unique<Process>(("watch" + std::to_string(number)).c_str(), change, show));
}

LineWatch::Process::Process(const sc_core::sc_module_name& name, const sc_core::sc_event& change,
                            std::function<void()> show)
    : sc_module(name), show_(std::move(show)) {
  SC_HAS_PROCESS(Process);
  SC_METHOD(run);
  sensitive << change;
  dont_initialize();
}

}  // namespace maquette::models
