// lammps-ricochet: LAMMPS with the granular models fractional, under the command line of `lmp`.

#include "stock_library.hpp"

#include <mpi.h>

#include "comm.h"
#include "exceptions.h"
#include "input.h"
#include "lammps.h"
#include "library.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <string_view>

namespace {

// The sub-models are compiled against the headers of one version, and headers of others look the same to a linker.
bool is_of_version(const LAMMPS_NS::LAMMPS& lmp, int built_for) {
  if (lmp.num_ver == built_for) return true;
  std::fprintf(stderr, "lammps-ricochet: was built for LAMMPS %d, and finds the library of %d: build it again\n",
               built_for, lmp.num_ver);
  return false;
}

// Whoever takes a deck for the LAMMPS of Debian 12 hears of a style that LAMMPS does not know, which tells nothing. The
// command that it has refused still stands in `input`.
void explain_words_of_2021(const LAMMPS_NS::LAMMPS& lmp) {
  const LAMMPS_NS::Input& input = *lmp.input;
  for (int i = 0; i < input.narg && lmp.comm->me == 0; ++i) {
    const std::string_view word = input.arg[i];
    if (word != "wall/fractional" && !(i == 0 && word == "fractional")) continue;
    std::fprintf(stderr,
                 "lammps-ricochet: %s: is for the LAMMPS of Debian 12 (29 Sep 2021); this one, of %s, has pair_style "
                 "granular with fractional models: see examples/lammps/debian13 and docs/lammps.md\n",
                 input.arg[i], lmp.version);
    return;
  }
}

void run_deck(LAMMPS_NS::LAMMPS& lmp) {
  try {
    lmp.input->file();
  } catch (const LAMMPS_NS::LAMMPSException&) {
    explain_words_of_2021(lmp);
    throw;
  }
}

int run(int argc, char** argv) {
  try {
    const auto lmp = std::make_unique<LAMMPS_NS::LAMMPS>(argc, argv, MPI_COMM_WORLD);
    if (!is_of_version(*lmp, RICOCHET_LAMMPS_VERSION)) return 4;
    ricochet::lammps::add_compute(*lmp);
    run_deck(*lmp);
    return 0;
  } catch (const LAMMPS_NS::LAMMPSAbortException& one_rank) {
    MPI_Abort(one_rank.get_universe(), 1);
  } catch (const LAMMPS_NS::LAMMPSException&) {
    return 1;  // it has said why
  } catch (const std::exception& other) {
    std::fprintf(stderr, "lammps-ricochet: %s\n", other.what());
    MPI_Abort(MPI_COMM_WORLD, 4);
  }
  return 4;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int code = run(argc, argv);
  lammps_kokkos_finalize();
  lammps_python_finalize();
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Finalize();
  return code;
}
