#include "runs/deck_run.hpp"

// The driver that is built here.
namespace engines {

std::string engine_command(int ranks) {
  const std::string mpi = RICOCHET_MPIEXEC " --allow-run-as-root --oversubscribe -np " + std::to_string(ranks) + " ";
  return (ranks > 1 ? mpi : "") + RICOCHET_DRIVER " -in in.deck";
}

std::filesystem::path runs_folder() { return RICOCHET_RUNS; }

}  // namespace engines
