#pragma once

#include <ricochet/motion/cluster.hpp>

#include <cmath>
#include <random>

namespace ricochet::test {

inline ClusterSetup with_law(NormalLaw law, Friction friction = {}, ContactEnd end = ContactEnd::force) {
  ClusterSetup setup;
  setup.interactions.insert({{0, 0}, {std::move(law), friction, end}});
  return setup;
}

/// Spheres in a loose clump that fly towards its centre and spin: many collisions, several at once.
inline ClusterSetup random_clump(unsigned seed, NormalLaw law, Friction friction, int count = 12) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> size(0.005, 0.012), offset(-0.0005, 0.0005), spin(-80, 80), side(-0.2, 0.2);
  ClusterSetup setup = with_law(std::move(law), friction);
  for (int k = 0; k < count; ++k) {
    // A lattice spaced so that the greatest two spheres are apart.
    const Vec3 lattice{0.026 * (k % 3 - 1), 0.026 * (k / 3 % 3 - 1), 0.026 * (k / 9 % 3 - 1)};
    Sphere s;
    s.radius = size(random);
    s.density = 1000 + 100 * k;
    s.position = lattice + Vec3{offset(random), offset(random), offset(random)};
    s.velocity = -60 * s.position + Vec3{side(random), side(random), side(random)};
    s.spin = {spin(random), spin(random), spin(random)};
    setup.spheres.push_back(s);
  }
  return setup;
}

/// The same with springs in the tangent plane of all contacts: sliding, torsion (which shares the disc's limit) and
/// rolling, each with a dashpot.
inline ClusterSetup with_springs(ClusterSetup setup, const TangentialLaw& law = LinearTangential(15000, 0.3)) {
  for (auto& [pair, interaction] : setup.interactions) {
    interaction.tangential = law;
    interaction.torsion = {Torsion::Limit::disc, {0.15, 3e-6}};
    interaction.rolling = {0.05, {0.2, 4e-6}};
  }
  return setup;
}

}  // namespace ricochet::test
