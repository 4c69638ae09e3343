#include <ricochet/ricochet.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

// A sphere on an undamped spring: t_col = π √(m/k) and e_n = 1, whatever the installed library was built with.
int main() {
  const double k = 1000;
  const double mass = 0.004;
  const auto collision = ricochet::collide(ricochet::Linear(k, 0), {.velocity = 0.5, .mass_eff = mass});
  const double expected = std::numbers::pi * std::sqrt(mass / k);
  std::printf("ricochet %s: tcol %.15g s, en %.15g\n", ricochet::version, collision.tcol, collision.en);
  return std::abs(collision.tcol / expected - 1) < 1e-12 && std::abs(collision.en - 1) < 1e-12 ? 0 : 1;
}
