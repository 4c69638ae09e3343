#include "convergence.hpp"

#include "run.hpp"

#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::cluster {

namespace {

using console::Notation;
using console::Table;

constexpr int meshes = 12;  // a level, with up to half as many steps again as its coarsest

// Greatest difference of any velocity at the end [m/s].
double distance(const Run& a, const Run& b) {
  double worst = 0;
  for (std::size_t i = 0; i < 5; ++i)
    worst = std::max(worst, norm(a.samples.back().velocity[i] - b.samples.back().velocity[i]));
  return worst;
}

/// Errors on the meshes of one level, taken back to its step by their order 2.
class Level {
 public:
  void add(double error) { errors_.push_back(error); }
  double mean() const {
    double sum = 0;
    for (const double e : errors_) sum += e;
    return sum / static_cast<double>(errors_.size());
  }
  /// Of the mean, relative.
  double standard_error() const {
    const double m = mean(), n = static_cast<double>(errors_.size());
    double sum = 0;
    for (const double e : errors_) sum += (e / m - 1) * (e / m - 1);
    return std::sqrt(sum / (n * (n - 1)));
  }

 private:
  std::vector<double> errors_;
};

/// What a force that starts like t^{1−α} may add to the velocities at a step h [m/s].
double start_term(const Run& run, double step) {
  const ClusterSetup setup = five_spheres(run.law);
  const double alpha = run.law.alpha, p = 1 - alpha, v0 = norm(setup.spheres[0].velocity);
  const double force = Fractional(run.law.k, run.law.c, alpha).coefficient() * v0;
  const double impulse = force * p * std::pow(2, 1 - p) / (24 * std::tgamma(1 + p)) * std::pow(step, 1 + p);
  double sum = 0;
  for (const Encounter& e : run.collisions)
    sum += impulse * (1 / setup.spheres[e.i].mass() + 1 / setup.spheres[e.j].mass()) * fractional_contact(alpha).en;
  return sum;
}

/// Three standard errors of the order from the first level to the last.
double noise(const std::array<Level, 3>& levels) {
  return 3 * std::hypot(levels[0].standard_error(), levels[2].standard_error()) / std::log(2.0) / 2;
}

Convergence::Errors errors_of(const std::array<Level, 3>& levels) {
  Convergence::Errors errors{{levels[0].mean(), levels[1].mean(), levels[2].mean()}};
  errors.order = 0.5 * std::log2(errors.mean[0] / errors.mean[2]);
  return errors;
}

Convergence::Errors of_velocity(const std::array<Level, 3>& levels, double alpha, double start, double kernel) {
  Convergence::Errors errors = errors_of(levels);
  const auto [low, high] = velocity_orders(alpha, start / errors.mean[2], kernel / errors.mean[2]);
  errors.low = low - noise(levels);
  errors.high = high + noise(levels);
  return errors;
}

Convergence::Errors of_energy(const std::array<Level, 3>& levels, double alpha) {
  Convergence::Errors errors = errors_of(levels);
  errors.low = 2 - alpha - noise(levels);
  errors.high = 2 + noise(levels);
  return errors;
}

}  // namespace

std::pair<double, double> velocity_orders(double alpha, double start_share, double kernel_share) {
  const double faster = 1 - std::pow(4.0, -alpha), all = 1 - std::pow(4.0, -2);
  return {2 + 0.5 * std::log2(1 - std::min(start_share, 1.0) * faster - kernel_share * all),
          2 + 0.5 * std::log2(1 + start_share * faster + kernel_share * all)};
}

Convergence converge(double alpha, double duration) {
  constexpr int coarsest = 375, finest = 48000;
  const auto with_steps = [&](int steps) { return run({alpha}, duration, duration / steps, duration); };
  const Run exact = with_steps(finest);
  std::array<Level, 3> velocity, energy;
  double kernel = exact.kernel_error;
  for (std::size_t level = 0; level < 3; ++level)
    for (int mesh = 0; mesh < meshes; ++mesh) {
      const int least = coarsest << level, steps = least + least * mesh / (2 * meshes);
      const Run r = with_steps(steps);
      const double to_level = std::pow(static_cast<double>(steps) / least, 2);
      velocity[level].add(to_level * distance(r, exact));
      energy[level].add(to_level * r.energy_drift);
      kernel = std::max(kernel, r.kernel_error);
    }
  const double step = duration / coarsest;
  const double start = start_term(exact, step / 4);
  const double v0 = norm(exact.samples.front().velocity[0]);
  return {alpha, step, of_velocity(velocity, alpha, start, 2 * kernel * v0), of_energy(energy, alpha)};
}

Table convergence_table(const std::vector<Convergence>& all) {
  const Notation sci{Notation::Kind::scientific, 2}, two{Notation::Kind::fixed, 2};
  Table table({{"alpha"},
               {"step", "s", sci},
               {"velocities", "m/s", sci},
               {"halved", "m/s", sci},
               {"quartered", "m/s", sci},
               {"order", "", two},
               {"energy balance", "", sci},
               {"halved ", "", sci},
               {"quartered ", "", sci},
               {"order ", "", two}},
              "Convergence: error of the velocities at the end and of the energy balance, k = 1000 kg/s²");
  for (const Convergence& c : all) {
    const Convergence::Errors &v = c.velocity, &e = c.energy;
    table.row({c.alpha, c.step, v.mean[0], v.mean[1], v.mean[2], v.order, e.mean[0], e.mean[1], e.mean[2], e.order});
  }
  table.note(fmt::format(
      "Means of {} meshes each. Stated order 2. The bounds are wider by what the force's start like t^(1-α) and the "
      "kernels' errors may add to the velocities, and go down to 2-α for the energy balance.",
      meshes));
  return table;
}

void convergence_gates(std::vector<Gate>& gates, const std::vector<Convergence>& all) {
  for (const Convergence& c : all) {
    const std::string at = fmt::format(", alpha = {}", c.alpha);
    gates.push_back(between("order of the velocities" + at, c.velocity.order, c.velocity.low, c.velocity.high));
    gates.push_back(
        between("order of the energy balance, 2 - alpha to 2" + at, c.energy.order, c.energy.low, c.energy.high));
  }
}

}  // namespace ricochet::verify::cluster
