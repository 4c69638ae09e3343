// liggghts-ricochet: LIGGGHTS with `model fractional`, under the command line of `liggghts`.

#include "fractional_styles.hpp"

#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

#include <csignal>
#include <memory>

namespace {

// As `liggghts` does: finish the step, write what was asked for, stop. Open MPI turns a rank's SIGINT into SIGTERM.
void stop_cleanly_on_signals() {
  std::signal(SIGINT, LAMMPS_NS::SignalHandler::int_handler);
  std::signal(SIGTERM, LAMMPS_NS::SignalHandler::int_handler);
  std::signal(SIGUSR1, LAMMPS_NS::SignalHandler::usr1_handler);
}

}  // namespace

int main(int argc, char** argv) {
  stop_cleanly_on_signals();
  MPI_Init(&argc, &argv);
  ricochet::liggghts::register_fractional_styles();
  {
    const auto engine = std::make_unique<LAMMPS_NS::LAMMPS>(argc, argv, MPI_COMM_WORLD);
    engine->input->file();
  }
  MPI_Finalize();
}
