#include "first_touch.hpp"

#include <ricochet/fractional/mittag_leffler.hpp>

#include <cmath>

namespace ricochet::half_step {

namespace {

/// coefficient·D^α of (t − t_b), t being one step after t_b, by kicks.
double pot_kick(double coefficient, double alpha, double theta, double dt) noexcept {
  const double p = 1 - alpha;
  return coefficient * (start_weight(p, theta) * std::pow(dt, p) / std::tgamma(1 + p));
}

/// Γ(5/2)/Γ(5/2 − α), which D^α puts before t^{3/2 − α}.
double hertz_factor(double alpha) noexcept { return std::tgamma(2.5) / std::tgamma(2.5 - alpha); }

/// t^{n−1} E_{α,n}(−(t/τ)^α): the arm's relaxation (n = 1), of which a constant rate makes the force (2) and its
/// impulse (3). Past the domain of `mittag_leffler` the first term of its asymptotics is right to 1e-6.
double arm_response(const FractionalZener& law, double t, int n) noexcept {
  constexpr double far = 1e6;
  const double alpha = law.alpha(), x = std::pow(t / law.tau(), alpha);
  if (alpha == 0) return std::pow(t, n - 1) / (2 * std::tgamma(n));
  return std::pow(t, n - 1) * (x < far ? mittag_leffler(alpha, n, -x) : 1 / (x * std::tgamma(n - alpha)));
}

}  // namespace

double start_weight(double p, double theta) noexcept {
  const double first = 1 + theta;
  const double last = first + 2;
  const double sum = std::pow(first, p) + std::pow(first + 1, p);
  const double power = std::pow(last, p);
  const double inverse = 1 / last;
  const double tail =
      power * (last / (1 + p) - 0.5 + inverse * p / 12 - inverse * inverse * inverse * p * (1 - p) * (2 - p) / 720);
  return tail - sum;
}

double first_kick(const Fractional& law, double rate, double theta, double dt) noexcept {
  return rate * pot_kick(law.coefficient(), law.alpha(), theta, dt);
}

double first_kick(const FractionalKelvinVoigt& law, double rate, double theta, double dt) noexcept {
  return rate * (law.k() * dt * start_weight(1, theta) + pot_kick(law.c(), law.alpha(), theta, dt));
}

double first_kick(const FractionalHertz& law, double rate, double theta, double dt) noexcept {
  const double alpha = law.alpha();
  const double of_c = law.c() * hertz_factor(alpha) * std::pow(dt, -alpha) * start_weight(1.5 - alpha, theta);
  return std::pow(rate * dt, 1.5) * (law.k() * start_weight(1.5, theta) + of_c);
}

double first_kick(const FractionalZener& law, double rate, double theta, double dt) noexcept {
  const auto arm = [&](int k, int n) { return arm_response(law, (k + theta) * dt, n); };
  const double kicks = arm(3, 3) / dt - arm(1, 2) - arm(2, 2) - 0.5 * arm(3, 2) + dt / 12 * arm(3, 1);
  return rate * (law.k() * dt * start_weight(1, theta) + law.k1() * kicks);
}

double first_work(const Fractional& law, double rate, double since) noexcept {
  return law.coefficient() * rate * rate * std::pow(since, 2 - law.alpha()) / std::tgamma(3 - law.alpha());
}

double first_work(const FractionalKelvinVoigt& law, double rate, double since) noexcept {
  const double of_c = law.c() * std::pow(since, 2 - law.alpha()) / std::tgamma(3 - law.alpha());
  return rate * rate * (0.5 * law.k() * since * since + of_c);
}

double first_work(const FractionalHertz& law, double rate, double since) noexcept {
  const double alpha = law.alpha(), travelled = rate * since;
  return travelled * travelled * std::sqrt(travelled) *
         (law.k() / 2.5 + law.c() * hertz_factor(alpha) * std::pow(since, -alpha) / (2.5 - alpha));
}

double first_work(const FractionalZener& law, double rate, double since) noexcept {
  return rate * rate * (0.5 * law.k() * since * since + law.k1() * arm_response(law, since, 3));
}

}  // namespace ricochet::half_step
