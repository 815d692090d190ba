#include "tools/benchmark/simulation_process.hpp"

namespace maquette::benchmark {

ProcessUsage run_simulation(const Paths& paths, const std::string& folder,
                            const std::vector<std::string>& arguments) {
  std::vector<std::string> command{paths.program, "run", paths.scene, "--quiet",
                                   "--threads",   "1",   "--outdir",  paths.scratch + "/" + folder};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command);
}

}  // namespace maquette::benchmark
