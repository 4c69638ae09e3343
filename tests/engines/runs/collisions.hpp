#pragma once

#include "deck_run.hpp"

#include <string>
#include <vector>

namespace engines {

/// Head-on collisions of one collision time, of materials that differ in their restitution, each at several places in
/// the step where the grains may touch: the error of a step depends on it.
namespace collisions {
inline constexpr double tcol = 1e-4;  // [s]
inline constexpr double speed = 0.5;  // of approach [m/s]
inline const std::vector<int> steps_per_contact{25, 50, 100, 200};

/// One file for all: every material meets itself at every place, each pair with masses of its own; or the wall x = 0.
/// They touch within ten steps dt [s].
std::vector<Grain> grains(std::size_t materials, double dt, bool wall);
Box box(std::size_t materials, bool wall);
/// Steps after which all is over.
int steps_of_run(int steps_per_contact);

struct Errors {
  std::vector<double> tcol, en;  ///< relative, largest over the places, by steps_per_contact
};
/// Adds one such run to the errors by material.
void add_run(std::vector<Errors>& errors, const std::vector<Frame>& frames, const std::vector<double>& restitutions,
             double dt, bool wall);
/// Prints them, and checks their size and that they are of second order. `blind`: the restitution above which the time
/// of contact cannot be read from the forces.
void report_and_check(const std::string& title, const std::vector<double>& restitutions,
                      const std::vector<Errors>& errors, double blind = 1);
}  // namespace collisions

}  // namespace engines
