#pragma once

#include <ricochet/collision/scale_and_loss.hpp>

namespace ricochet::verify::benchmarks {

/// What a benchmark's bodies are made of.
struct Solid {
  const char* name;
  double young, poisson, density;  // Pa, –, kg/m³

  ElasticSolid elastic() const { return {young, poisson}; }
  /// E/(1−ν²), the E* of a sphere on a rigid plane [Pa].
  double modulus_on_rigid() const { return young / (1 - poisson * poisson); }
  /// A solid of ν = 0 whose E* with its like is that of this one on a rigid plane.
  ElasticSolid as_on_rigid() const { return {2 * modulus_on_rigid(), 0}; }
  /// (2−ν)/G, of which 1/G* is the sum over two bodies [1/Pa].
  double shear_compliance() const { return 2 * (2 - poisson) * (1 + poisson) / young; }
};

}  // namespace ricochet::verify::benchmarks
