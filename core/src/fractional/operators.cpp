#include <ricochet/support/require.hpp>
#include <ricochet/fractional/operators.hpp>

#include <cmath>

namespace ricochet {

namespace {

void require_order(double alpha) {
  support::require(alpha > 0 && alpha < 1, "alpha", alpha, "between 0 and 1, exclusive");
}

// Higher orders exist, but h^β leaves the range of a double there.
void require_beta(double beta) { support::require(beta > 0 && beta <= 10, "beta", beta, "in (0, 10]"); }

/// h^power over a Γ, which all weights of a rule are multiples of.
double weight_scale(double step, double power, double gamma) {
  support::require_positive("step", step);
  const double scale = std::pow(step, power) / gamma;
  support::require(std::isnormal(scale), "step", step, "such that its power in the weights is a normal double");
  return scale;
}

/// Σ_{k ≡ parity mod 2} C(q, k) x^k moment(k): the differences below as series about the middle, because their closed
/// forms cancel for old samples. For |x| ≤ 1/8 twenty terms reach rounding.
template <class Moment>
double binomial_series(double q, double x, int parity, Moment moment) {
  double sum = 0, term = 1;
  for (int k = 0; k < 20; ++k) {
    if (k % 2 == parity) sum += term * moment(k);
    term *= (q - k) / (k + 1) * x;
  }
  return sum;
}

/// (j+1)^p − j^p.
double first_difference(double p, double j) {
  if (j < 8) return std::pow(j + 1, p) - (j > 0 ? std::pow(j, p) : 0);
  const double m = j + 0.5;  // p ∫_{−1/2}^{1/2} (m+v)^{p−1} dv
  return p * std::pow(m, p - 1) * binomial_series(p - 1, 0.5 / m, 0, [](int k) { return 1.0 / (k + 1); });
}

/// (j+1)^p − 2 j^p + (j−1)^p, j ≥ 1.
double second_difference(double p, double j) {
  if (j < 8) return std::pow(j + 1, p) - 2 * std::pow(j, p) + (j > 1 ? std::pow(j - 1, p) : 0);
  return 2 * std::pow(j, p) * (binomial_series(p, 1 / j, 0, [](int k) { return k == 0 ? 0.0 : 1.0; }));
}

/// (n−1)^p − (n−p) n^{p−1}, n ≥ 1: the weight of the first sample in the product trapezoid, p = β+1.
double trapezoid_first(double p, double n) {
  if (n < 8) return (n > 1 ? std::pow(n - 1, p) : 0) - (n - p) * std::pow(n, p - 1);
  // n^p Σ_{k≥2} C(p, k) (−1/n)^k
  const auto tail = [](int k) { return k < 2 ? 0.0 : 1.0; };
  return std::pow(n, p) * (binomial_series(p, -1 / n, 0, tail) + binomial_series(p, -1 / n, 1, tail));
}

/// ∫_j^{j+1} u^{−α} (j + 1/2 − u) du: what a step's curvature adds to L1.
double curvature_weight(double alpha, double j) {
  const double m = j + 0.5;
  if (j < 8) return m * first_difference(1 - alpha, j) / (1 - alpha) - first_difference(2 - alpha, j) / (2 - alpha);
  // −∫ v (m+v)^{−α} dv over |v| < 1/2: odd powers, ∫ v^{k+1} = (1/2)^{k+2}·2/(k+2)
  return -0.5 * std::pow(m, -alpha) * binomial_series(-alpha, 0.5 / m, 1, [](int k) { return 1.0 / (k + 2); });
}

}  // namespace

ConvolutionRule rectangle_integral(double beta, double step, std::size_t steps) {
  require_beta(beta);
  const double scale = weight_scale(step, beta, std::tgamma(beta + 1));
  // The sample x_l acts over (t_l, t_{l+1}): weight (n−l)^β − (n−l−1)^β; the last has not acted yet.
  std::vector<double> w(steps + 1);
  for (std::size_t j = 1; j <= steps; ++j) w[j] = scale * first_difference(beta, static_cast<double>(j) - 1);
  return ConvolutionRule(std::move(w));
}

ConvolutionRule rectangle_derivative(double alpha, double step, std::size_t steps) {
  require_order(alpha);
  return rectangle_integral(1 - alpha, step, steps);
}

ConvolutionRule trapezoid_integral(double beta, double step, std::size_t steps) {
  require_beta(beta);
  const double scale = weight_scale(step, beta, std::tgamma(beta + 2));
  std::vector<double> w(steps + 1), first(steps + 1);
  w[0] = scale;
  first[0] = -scale;
  for (std::size_t j = 1; j <= steps; ++j) {
    w[j] = scale * second_difference(beta + 1, static_cast<double>(j));
    first[j] = scale * trapezoid_first(beta + 1, static_cast<double>(j)) - w[j];
  }
  return ConvolutionRule(std::move(w), std::move(first));
}

ConvolutionRule trapezoid_derivative(double alpha, double step, std::size_t steps) {
  require_order(alpha);
  return trapezoid_integral(1 - alpha, step, steps);
}

ConvolutionRule l1_derivative(double alpha, double step, std::size_t steps) {
  require_order(alpha);
  const double scale = weight_scale(step, -alpha, std::tgamma(2 - alpha)), p = 1 - alpha;
  std::vector<double> w(steps + 1), first(steps + 1);
  w[0] = scale;
  first[0] = -scale;
  for (std::size_t j = 1; j <= steps; ++j) {
    w[j] = scale * second_difference(p, static_cast<double>(j));
    first[j] = -scale * first_difference(p, static_cast<double>(j));
  }
  return ConvolutionRule(std::move(w), std::move(first));
}

ConvolutionRule l12_derivative(double alpha, double step, std::size_t steps) {
  const ConvolutionRule l1 = l1_derivative(alpha, step, steps);
  const double scale = std::pow(step, -alpha) / std::tgamma(1 - alpha);
  std::vector<double> c(steps + 1);  // of the second difference that ends j steps ago
  for (std::size_t j = 0; j <= steps; ++j) c[j] = scale * curvature_weight(alpha, static_cast<double>(j));
  std::vector<double> w(l1.weights().begin(), l1.weights().end()), first(l1.first().begin(), l1.first().end());
  std::vector<double> second(steps + 1);
  for (std::size_t n = 0; n <= steps; ++n) {
    w[n] += c[n] - (n >= 1 ? 2 * c[n - 1] : 0) + (n >= 2 ? c[n - 2] : 0);
    // No second difference ends at l = 0 or 1: take out what the convolution put there.
    first[n] -= c[n] - (n >= 1 ? 2 * c[n - 1] : 0);
    if (n >= 1) second[n] = -c[n - 1];
  }
  return ConvolutionRule(std::move(w), std::move(first), std::move(second));
}

ConvolutionRule gruenwald_letnikov_derivative(double alpha, double step, std::size_t steps) {
  require_order(alpha);
  std::vector<double> w(steps + 1);
  w[0] = weight_scale(step, -alpha, 1);
  for (std::size_t j = 1; j <= steps; ++j)
    w[j] = w[j - 1] * (static_cast<double>(j) - 1 - alpha) / static_cast<double>(j);
  return ConvolutionRule(std::move(w));
}

namespace {

void require_mesh(std::span<const double> times, std::span<const double> samples) {
  support::require(times.size() >= 2 && samples.size() == times.size(), "samples", static_cast<double>(samples.size()),
                   "as many as times, at least 2");
}

/// b^p − a^p for 0 ≤ a < b without cancellation.
double power_difference(double p, double a, double b) {
  return a > 0 ? std::pow(b, p) * -std::expm1(p * std::log1p((a - b) / b)) : std::pow(b, p);
}

}  // namespace

double l1_derivative(double alpha, std::span<const double> times, std::span<const double> values) {
  require_order(alpha);
  require_mesh(times, values);
  const double end = times.back();
  double sum = 0;
  for (std::size_t l = 1; l < times.size(); ++l)
    sum += (values[l] - values[l - 1]) / (times[l] - times[l - 1]) *
           power_difference(1 - alpha, end - times[l], end - times[l - 1]);
  return sum / std::tgamma(2 - alpha);
}

double trapezoid_derivative(double alpha, std::span<const double> times, std::span<const double> rates) {
  require_order(alpha);
  require_mesh(times, rates);
  const double end = times.back(), p = 1 - alpha;
  double sum = 0;
  for (std::size_t l = 1; l < times.size(); ++l) {
    // ∫ u^{−α} (rate linear) over u in (near, far): with the slope s, rate(u) = rates[l] − s (u − near).
    const double near = end - times[l], far = end - times[l - 1], h = times[l] - times[l - 1];
    const double mass = power_difference(p, near, far) / p, first = power_difference(p + 1, near, far) / (p + 1);
    sum += rates[l] * mass + (rates[l - 1] - rates[l]) / h * (first - near * mass);
  }
  return sum / std::tgamma(1 - alpha);
}

std::vector<double> graded_mesh(double end, std::size_t steps, double grading) {
  support::require_positive("end", end);
  support::require(steps > 0, "steps", static_cast<double>(steps), "at least 1");
  support::require(std::isfinite(grading) && grading >= 1, "grading", grading, "at least 1");
  std::vector<double> t(steps + 1);
  for (std::size_t l = 0; l <= steps; ++l)
    t[l] = end * std::pow(static_cast<double>(l) / static_cast<double>(steps), grading);
  return t;
}

}  // namespace ricochet
