#pragma once

#include "../runs/deck_run.hpp"

#include <string>

namespace engines {

// What decks for LAMMPS are put together from. Which styles have the law depends on LAMMPS's version: each of its test
// programs defines the functions of the second part for its own.

/// Settings that every deck starts with.
std::string preamble(const Box& box, const std::string& processors = "* 1 1");
/// The grains' neighbour list.
std::string neighbours(const std::string& skin = "0.0005", const std::string& rebuilds = "delay 0");
/// `pair_style` with one law for all.
std::string one_law(const std::string& law, const std::string& settings = "");
/// Two planes across an axis (xplane, yplane, zplane) for all grains, "NULL" for one that is not there.
std::string planes(const std::string& axis, const std::string& low, const std::string& high, const std::string& law,
                   const std::string& settings = "");
std::string move(double dt);
std::string dump(const std::string& file, int every = 1);
std::string run(int steps);

/// A law by its collision, or by its parameters.
std::string target(double tcol, double en);
std::string parameters(double k, double c, double alpha);
/// Settings: how long contacts remember [s]; what `energies` needs.
std::string memory(double time);
std::string tallied();

std::string pair_style(const std::string& settings = "");
std::string pair_coeff(const std::string& types, const std::string& law, const std::string& settings = "");
std::string wall(const std::string& name, const std::string& group, const std::string& planes, const std::string& law,
                 const std::string& settings = "");
/// What a deck has to say of the pairs again after read_restart.
std::string after_restart(const std::string& styles);
/// Variables v_stored and v_lost [J] of the contacts of pairs and of planes across all axes.
std::string energies();

}  // namespace engines
