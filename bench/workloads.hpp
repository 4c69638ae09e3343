#pragma once

#include <ricochet/contact/fractional.hpp>
#include <ricochet/motion/cluster.hpp>
#include <ricochet/motion/column.hpp>
#include <ricochet/collision/reduction.hpp>

#include <cmath>
#include <random>
#include <stdexcept>
#include <variant>
#include <vector>

// What is timed here is what tests/instructions counts the instructions of.
namespace ricochet::workloads {

/// Arguments in random order, so that neither branches nor caches are flattered.
inline std::vector<double> arguments(double low, double high, std::size_t count = 1024) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> draw(low, high);
  std::vector<double> x(count);
  for (double& value : x) value = draw(random);
  return x;
}

/// The loosest kernel with the given number of arms, over 1000 steps.
inline MemoryKernel kernel_of(std::size_t arms, double alpha, double step) {
  for (double tolerance = 1e-2; tolerance > 1e-12; tolerance /= 1.5) {
    MemoryKernel kernel = memory_kernel(alpha, step, 1000 * step, tolerance);
    if (kernel.arms().size() == arms) return kernel;
  }
  throw std::runtime_error("no kernel with so many arms");
}

/// A law of α, on 12 arms.
template <RemembersAll Law>
typename Law::Arms on_12_arms(const Law& law, double step) {
  constexpr std::size_t more = Law::Arms::max_arms - Law::Arms::max_kernel_arms;  // than its kernel's has a law
  return {law, kernel_of(12 - more, law.alpha(), step), step};
}

/// A column whose beads are pressed together at a uniform rate: every contact is active for `pressed_steps`.
struct PressedColumn {
  static constexpr double mass = 1.41e-5, tcol = 1e-4, en = 0.945, step = tcol / 200;
  static constexpr int first_steps = 3, pressed_steps = 30;

  static Column of(std::size_t beads) {
    Column column = equal_column(beads, mass, 0, 0);
    for (std::size_t i = 0; i < beads; ++i) column.velocity[i] = -0.5 * static_cast<double>(i + 1);
    return column;
  }
  template <class Law>
  static Law plate(LawKind kind) {
    return std::get<Law>(tuned_law(kind, tcol, en, {0.5, mass}));
  }
  template <class Law>
  static Law pair(LawKind kind) {
    return std::get<Law>(tuned_law(kind, tcol, en, {0.5, mass / 2}));
  }
};

/// Square layers of spheres, each in the hollows of the one below, in a box.
inline ClusterSetup packing(int across, int layers, const AnyLaw& law, const Friction& friction) {
  constexpr double radius = 0.005, density = 2500, spacing = 2.04 * radius;
  ClusterSetup setup;
  setup.gravity = {0, 0, -9.81};
  setup.interactions.insert({{0, 0}, {law, friction}});
  const double rise = std::sqrt(4 * radius * radius - spacing * spacing / 2);
  for (int n = 0; n < layers; ++n)
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j) {
        const double shift = n % 2 == 0 ? 0 : spacing / 2;
        setup.spheres.push_back(
            {radius, density, {i * spacing + shift, j * spacing + shift, radius + n * rise}, {}, {}, 0});
      }
  const double side = (across - 0.5) * spacing + radius;
  setup.walls = box_walls({-radius, -radius, 0}, {side, side, 1});
  return setup;
}

/// One sweep a step: what a contact costs, apart from how often the sweeps repeat. 2·10⁻⁶ over 1000 steps is what 12
/// arms reach.
inline ClusterOptions packing_options() {
  constexpr double step = 6e-6;
  return {.step = step, .longest_contact = 1000 * step, .kernel_tolerance = 2e-6, .max_sweeps = 1};
}

}  // namespace ricochet::workloads
