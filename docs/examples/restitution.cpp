#include <ricochet/ricochet.hpp>

#include <cstdio>

int main() {
  // The restitution alone fixes the fractional law's conversion degree.
  const double alpha = ricochet::conversion_degree(0.5);
  const auto contact = ricochet::fractional_contact(alpha);
  std::printf("fractional: alpha = %.6f, greatest overlap = %.4f v0 tcol\n", alpha, contact.max_overlap);

  const ricochet::Linear law(5211.51942, 0.097991326);  // k [kg/s^2], c [kg/s]
  const auto collision = ricochet::collide(law, {.velocity = 0.5, .mass_eff = 7.06858e-6});
  std::printf("linear: tcol = %.4g s, en = %.4f\n", collision.tcol, collision.en);
}
