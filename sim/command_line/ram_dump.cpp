#include "sim/command_line/ram_dump.hpp"

#include <fmt/format.h>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

std::vector<int> checked_boards(const std::vector<int>& boards, bool executed,
                                const Machine& machine) {
  const auto count = static_cast<int>(machine.parameters.boards.size());
  for (const int board : boards) {
    const SourcePosition position{fmt::format("--dump-ram {}", board), 1, 1};
    if (!executed) {
      throw DescriptionError(position,
                             "only boards that execute their program work in their RAM; allowed "
                             "with --processor instruction");
    }
    if (board < 0 || board >= count) {
      throw DescriptionError(position, fmt::format("no such board; allowed: 0 to {}", count - 1));
    }
  }
  return boards;
}

void add_ram_files(const std::vector<int>& boards, const SimulationResult& result,
                   std::vector<NamedContent>& files) {
  for (std::size_t i = 0; i < result.rams.size(); ++i) {
    const std::vector<unsigned char>& ram = result.rams[i];
    files.push_back({fmt::format("ram-{}.bin", boards[i]), std::string(ram.begin(), ram.end())});
  }
  if (!result.rams.empty()) {
    files.push_back({"ram.map", result.symbols});
  }
}

}  // namespace maquette::sim
