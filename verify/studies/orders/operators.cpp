// The discrete operators and what each is said to do.

#include "../convergence.hpp"

#include <ricochet/fractional/mittag_leffler.hpp>

#include <cmath>

namespace ricochet::verify {

namespace {

/// A function with its rate and its exact D^α, or I^β where `order` is −β, at t = 1.
struct Tested {
  std::string name;
  std::function<double(double)> value, rate;
  double exact;
};

constexpr int tested[] = {1, 2, 3, 0, -1};

const char* name_of(int p) {
  constexpr const char* powers[] = {"sin t", "t", "t^2", "t^3"};
  return p < 0 ? "contact" : powers[p];
}

/// p > 0: t^p. p = 0: sin t = t E_{2,2}(−t²), so D^α sin t = t^{1−α} E_{2,2−α}(−t²). p = −1: the collision's own motion
/// at order a = contact_alpha, A = v₀ = 1: t E_{2−a,2}(−t^{2−a}), whose derivatives of order q are t^{1−q} E_{2−a,2−q}.
Tested tested_function(int p, double order, double contact_alpha) {
  if (p > 0)
    return {name_of(p), [p](double t) { return std::pow(t, p); }, [p](double t) { return p * std::pow(t, p - 1); },
            std::tgamma(p + 1.0) / std::tgamma(p + 1.0 - order)};
  if (p == 0)
    return {name_of(p), [](double t) { return std::sin(t); }, [](double t) { return std::cos(t); },
            mittag_leffler(2, 2 - order, -1)};
  const double a = 2 - contact_alpha;
  const MittagLeffler value(a, 2), rate(a, 1);
  return {name_of(p), [=](double t) { return t * value(-std::pow(t, a)); },
          [=](double t) { return rate(-std::pow(t, a)); }, mittag_leffler(a, 2 - order, -1)};
}

Statement stated(const std::string& scheme, double alpha, int p, std::optional<double> order, double allowed) {
  return {scheme, name_of(p), alpha, order, allowed};
}

// Allowed deviations. Next to h^p stands, at a fixed time, a term of order p + gap. Where the gap is below 1/2 the
// slopes between N = 512 and 4096 still carry it: |observed − p| ≈ gap·|c₂/c₁| 2000^{−gap}, up to about gap/2 for
// coefficients of one size. 0.15 is allowed for gap < 1/2, 0.1 else.
double allowance(double gap) { return gap < 0.5 ? 0.15 : 0.1; }

using Stated = std::function<Statement(double alpha, int p)>;

Operator derivative_from_rate(const std::string& name, Operator::Make* make, Stated statement) {
  return {name, Operator::Samples::rate, false, make, std::move(statement)};
}
Operator derivative_from_values(const std::string& name, Operator::Make* make, Stated statement) {
  return {name, Operator::Samples::values, false, make, std::move(statement)};
}
Operator integral_of(const std::string& name, Operator::Make* make, Stated statement) {
  return {name, Operator::Samples::values, true, make, std::move(statement)};
}

}  // namespace

std::vector<Operator> fractional_operators() {
  std::vector<Operator> all;
  // Rectangle: h/2 ∫ of the slope, then h^{1+β} from the last step (β = 1−α for the derivative).
  all.push_back(derivative_from_rate("(59) derivative", rectangle_derivative, [](double a, int p) {
    return stated("(59) derivative", a, p, p == 1 ? std::nullopt : std::optional(1.0), allowance(1 - a));
  }));
  all.push_back(integral_of("(60) integral", rectangle_integral,
                            [](double b, int p) { return stated("(60) integral", b, p, 1.0, allowance(b)); }));
  // L1: h^{2−α} from the last step, then h².
  all.push_back(derivative_from_values("L1", l1_derivative, [](double a, int p) {
    return stated("L1", a, p, p == 1 ? std::nullopt : std::optional(2 - a), allowance(a));
  }));
  // L1-2: h^{3−α} from the last step, then h³; parabolas err in the first step alone, h³.
  all.push_back(derivative_from_values("L1-2", l12_derivative, [](double a, int p) {
    const std::optional<double> order = p == 1 ? std::nullopt : std::optional(p == 2 ? 3 : 3 - a);
    return stated("L1-2", a, p, order, p == 2 ? 0.1 : allowance(a));
  }));
  // Product trapezoid: h²/12 ∫ of the curvature, then h^{2+β}.
  all.push_back(derivative_from_rate("trapezoid derivative", trapezoid_derivative, [](double a, int p) {
    const bool exact = p == 1 || p == 2;
    return stated("trapezoid derivative", a, p, exact ? std::nullopt : std::optional(2.0), allowance(1 - a));
  }));
  all.push_back(integral_of("trapezoid integral", trapezoid_integral, [](double b, int p) {
    return stated("trapezoid integral", b, p, p == 1 ? std::nullopt : std::optional(2.0), allowance(b));
  }));
  // Grünwald-Letnikov: −αh/2 D^{α+1}, then h².
  all.push_back(derivative_from_values("Gruenwald-Letnikov", gruenwald_letnikov_derivative, [](double a, int p) {
    return stated("Gruenwald-Letnikov", a, p, 1.0, allowance(1));
  }));
  return all;
}

std::vector<Convergence> measure(const Operator& op, double alpha, const std::vector<std::size_t>& steps) {
  std::vector<Convergence> all;
  for (const int p : tested) {
    const Tested f = tested_function(p, op.integral ? -alpha : alpha, alpha);
    const auto& sample = op.samples == Operator::Samples::rate ? f.rate : f.value;
    Convergence c{.statement = op.statement(alpha, p), .scale = std::fabs(f.exact)};
    for (const std::size_t n : steps) {
      std::vector<double> x(n + 1);
      for (std::size_t l = 0; l <= n; ++l) x[l] = sample(static_cast<double>(l) / static_cast<double>(n));
      const double error = op.make(alpha, 1 / static_cast<double>(n), n).last(x) - f.exact;
      c.steps.push_back(n);
      c.values.push_back(error);
      c.errors.push_back(std::fabs(error));
    }
    all.push_back(std::move(c));
  }
  return all;
}

}  // namespace ricochet::verify
