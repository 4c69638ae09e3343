// The largest step that ColumnEngine's scheme bears.
#include <ricochet/motion/column.hpp>

#include "steepest.hpp"

#include <ricochet/support/root.hpp>

#include <limits>
#include <utility>

namespace ricochet {
namespace motion {
namespace {

// g = kh/2 + c.
template <class Law>
double at_steepest(const Law& law, double w, double mass, double speed) {
  const Steepest at = steepest(law, mass, speed);
  return 1 / (w * at.damping + std::sqrt(w * at.damping * w * at.damping + w * at.stiffness));
}

// √(2E), E the kinetic energy at the start, where any two bodies then approach each other; else 0.
double root_of_energy(const Column& column) {
  const auto [slowest, fastest] = std::minmax_element(column.velocity.begin(), column.velocity.end());
  if (*fastest == *slowest && *slowest >= 0) return 0;
  double root = 0;
  for (std::size_t i = 0; i < column.mass.size(); ++i)
    root = std::hypot(root, std::sqrt(column.mass[i]) * column.velocity[i]);
  return root;
}

}  // namespace

double stable_step(const Linear& law, double w, double mass, double speed) { return at_steepest(law, w, mass, speed); }
double stable_step(const KuwabaraKono& law, double w, double mass, double speed) {
  return at_steepest(law, w, mass, speed);
}
double stable_step(const Tsuji& law, double w, double mass, double speed) { return at_steepest(law, w, mass, speed); }
double stable_step(const Hysteretic& law, double w, double mass, double speed) {
  return at_steepest(law, w, mass, speed);
}
// g = c^α k^{1−α} h^{1−α}/Γ(3−α), the mean of D^α over a step of constant rate.
double stable_step(const Fractional& law, double w, double, double) {
  return std::pow(std::tgamma(3 - law.alpha()) / (2 * w * law.coefficient()), 1 / (2 - law.alpha()));
}

namespace {

// g = kh/2 + c h^{1−α}/Γ(3−α): between the roots for either alone and 1/√2 of them.
double spring_and_pot(double k, double c, double alpha, double w) {
  const double pot = c / std::tgamma(3 - alpha), infinity = std::numeric_limits<double>::infinity();
  const double by_pot = pot > 0 ? std::pow(2 * w * pot, -1 / (2 - alpha)) : infinity;
  const double by_spring = k > 0 ? 1 / std::sqrt(w * k) : infinity, low = std::min(by_spring, by_pot);
  if (std::max(by_spring, by_pot) == infinity) return low;
  const auto excess = [&](double share) {
    const double h = share * low;
    return w * h * (0.5 * k * h + pot * std::pow(h, 1 - alpha)) - 0.5;
  };
  return low * support::root(excess, 0.4, 1, -1, std::max(0.0, excess(1)));
}

}  // namespace

double stable_step(const FractionalKelvinVoigt& law, double w, double, double) {
  return spring_and_pot(law.k(), law.c(), law.alpha(), w);
}
// The arm is never stiffer than its spring alone or its springpot alone.
double stable_step(const FractionalZener& law, double w, double, double) {
  const double pot = law.k1() * std::pow(law.tau(), law.alpha());
  return std::max(spring_and_pot(law.k() + law.k1(), 0, law.alpha(), w), spring_and_pot(law.k(), pot, law.alpha(), w));
}
double stable_step(const FractionalHertz& law, double w, double mass, double speed) {
  const double rise = 1.5 * std::sqrt(greatest_overlap(law, mass, speed));
  return spring_and_pot(rise * law.k(), rise * law.c(), law.alpha(), w);
}

double stable_step(collision::DrivenLaw& law, double w, double mass, double speed) {
  const Impact impact{.velocity = std::max(speed, 1e-9), .mass_eff = mass};
  const double change = 1e-3 * impact.velocity;
  double least = std::numeric_limits<double>::infinity();
  collision::walk(law, impact, [&](const Instant& at) {
    const auto too_long = [&](double h) {
      const double faster = law.mean({at.overlap, at.rate + change}, h),
                   slower = law.mean({at.overlap, at.rate - change}, h);
      return w * h * (faster - slower) / (2 * change) > 0.5;
    };
    double high = std::min(least, 1e9), low = high;
    if (!too_long(high)) return;
    while (too_long(low) && low > 1e-100) low /= 16;
    for (int i = 0; i < 40; ++i) {
      const double middle = std::sqrt(low * high);
      (too_long(middle) ? high : low) = middle;
    }
    least = low;
  });
  return least;
}

double least_stable_step(const Column& column, const std::function<double(bool, double, double, double)>& of_contact) {
  check(column);
  const double root = root_of_energy(column);
  const std::size_t beads = column.mass.size();
  const auto inverse_mass = [&](std::size_t body) { return body == 0 ? 0.0 : 1 / column.mass[body - 1]; };
  double largest = std::numeric_limits<double>::infinity();
  std::pair<double, double> last{0, 0};  // w and mass of the contact below: long columns repeat themselves
  for (std::size_t j = 1; j <= beads; ++j) {
    // Gershgorin's bound: contact j feels its own force through both its bodies, a neighbour's through the one they
    // share.
    const double below = inverse_mass(j - 1), above = inverse_mass(j);
    const double w = (j > 1 ? 2 : 1) * below + (j < beads ? 2 : 1) * above, mass = 1 / (below + above);
    if (j > 2 && last == std::pair(w, mass)) continue;
    last = {w, mass};
    // No contact closes with more than all the energy there is: a light bead between heavy ones may be given theirs.
    largest = std::min(largest, of_contact(j == 1, w, mass, root / std::sqrt(mass)));
  }
  return largest;
}

}  // namespace motion

double largest_step(const Column& column, const AnyLaw& plate, const AnyLaw& pair) {
  return motion::least_stable_step(column, [&](bool at_plate, double w, double mass, double speed) {
    return std::visit([&](const auto& law) { return motion::stable_step(law, w, mass, speed); },
                      at_plate ? plate : pair);
  });
}

}  // namespace ricochet
