// lammps-ricochet: the LAMMPS of Debian 12 (29 Sep 2021) with `pair_style fractional` and `fix wall/fractional`, under
// the command line of `lmp`.

#include "engine_headers.hpp"
#include "fix_wall_fractional.hpp"
#include "pair_contacts.hpp"
#include "pair_fractional.hpp"

#include <dlfcn.h>
#include <mpi.h>

#include <cstdlib>
#include <exception>
#include <string_view>
#include <typeinfo>

namespace {

using namespace ricochet::lammps;

template <class Style>
LAMMPS_NS::Pair* make_pair_style(LAMMPS_NS::LAMMPS* lmp) {
  return new Style(lmp);
}

template <class Style>
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) {
  return new Style(lmp, narg, arg);
}

void add_styles(LAMMPS_NS::LAMMPS& lmp) {
  if (lmp.num_ver != RICOCHET_LAMMPS_VERSION)
    lmp.error->all(FLERR, fmt::format("lammps-ricochet was built for LAMMPS {} and runs with {}: build it anew",
                                      RICOCHET_LAMMPS_VERSION, lmp.num_ver));
  (*lmp.force->pair_map)["fractional"] = &make_pair_style<PairFractional>;
  (*lmp.modify->fix_map)["wall/fractional"] = &make_fix<FixWallFractional>;
  (*lmp.modify->fix_map)[PairContacts::style_name] = &make_fix<PairContacts>;
}

const LAMMPS_NS::LAMMPS* reading = nullptr;  // the engine, while it reads its deck

// Whoever takes a deck for the LAMMPS of Debian 13 hears of a word that LAMMPS does not know, which tells nothing. It
// ends the process there; the command that it has refused still stands in `input`.
void explain_words_of_2025() {
  if (!reading || reading->comm->me != 0) return;
  const LAMMPS_NS::Input& input = *reading->input;
  const auto word = [&](int i) { return i < 0 ? std::string_view() : std::string_view(input.arg[i]); };
  for (int i = 0; i < input.narg; ++i) {
    if (!word(i).starts_with("fractional/") && !(word(i) == "fractional" && word(i - 1) == "damping")) continue;
    fmt::print(stderr,
               "lammps-ricochet: {}: is for the LAMMPS of Debian 13 (4 Feb 2025); this one, of 29 Sep 2021, has "
               "pair_style fractional and fix wall/fractional: see examples/lammps/debian12 and docs/lammps.md\n",
               word(i));
    return;
  }
}

void read_deck(LAMMPS_NS::LAMMPS& lmp) {
  reading = &lmp;
  std::atexit(explain_words_of_2025);
  lmp.input->file();
  reading = nullptr;
}

}  // namespace

// LAMMPS's library calls this when it has made its lists of styles: at its start, and at each `clear` of a deck. The
// program's definition goes before the library's, which does the rest.
void LAMMPS_NS::LAMMPS::post_create() {
  add_styles(*this);
  using PostCreate = void (*)(LAMMPS_NS::LAMMPS*);
  if (void* const theirs = dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"))
    reinterpret_cast<PostCreate>(theirs)(this);
}

// LAMMPS has said what was wrong before it throws. What only one rank met must not leave the others waiting; the class
// that says so is in a header which Debian does not ship.
int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    LAMMPS_NS::LAMMPS engine(argc, argv, MPI_COMM_WORLD);
    read_deck(engine);
  } catch (const std::exception& error) {
    code = 1;
    reading = nullptr;  // is gone
    if (std::string_view(typeid(error).name()).find("Abort") != std::string_view::npos) MPI_Abort(MPI_COMM_WORLD, code);
  }
  MPI_Finalize();
  return code;
}
