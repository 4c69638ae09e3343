#pragma once

#include "../runs/deck_run.hpp"

#include <string>
#include <vector>

namespace engines {

/// A normal model of ours, with the properties that it takes beside collisionTime and coefficientRestitution, for
/// impacts of 0.5 m/s.
struct Model {
  std::string name, properties;
};
/// All of them, the fractional law first.
std::vector<Model> our_models();

/// Settings that every deck starts with; `newton off` and `map array` are what granular runs use.
std::string preamble(const Box& box, const std::string& processors = "* 1 1");
/// `fix property/global NAME peratomtypepair` of a symmetric matrix.
std::string pair_property(const std::string& name, const std::vector<std::vector<double>>& matrix);
/// The same value for all of n types.
std::string pair_property(const std::string& name, double value, int types = 1);
/// Positions, velocities and forces at full precision each `every` steps into `file`.
std::string dump_command(const std::string& file, int every = 1);

/// Writes a square in the plane x = 0, of two triangles, as an STL file: low … high in y and z.
void write_square(const std::filesystem::path& file, double low, double high);

}  // namespace engines
