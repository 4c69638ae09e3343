#include "memory_collocation.hpp"

#include <ricochet/support/root.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

namespace ricochet::collision {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr int size = 16;
using Square = Eigen::Matrix<double, size, size>;
using Row = Eigen::Matrix<double, size, 1>;

constexpr double first_end = 1e-5;  // up to where two terms of the series are taken
constexpr int most_panels = 600;

/// Gauss's rule of N points on (0, 1).
template <unsigned N>
struct GaussRule {
  std::array<double, N> at{}, weight{};
  GaussRule() {
    const auto& x = boost::math::quadrature::gauss<double, N>::abscissa();
    const auto& w = boost::math::quadrature::gauss<double, N>::weights();
    for (std::size_t i = 0; i < N / 2; ++i) {
      at[i] = 0.5 * (1 - x[i]), at[N - 1 - i] = 0.5 * (1 + x[i]);
      weight[i] = weight[N - 1 - i] = 0.5 * w[i];
    }
  }
};

/// What all panels share: 16 Chebyshev points on [0, 1] with both ends.
struct Mesh {
  Row at;
  Square to_coefficients, integral, slope;  // Chebyshev coefficients; ∫ from 0; d/dτ
  GaussRule<16> fine;
  GaussRule<8> coarse;
  Eigen::Matrix<double, 16, size> on_fine;
  Eigen::Matrix<double, 8, size> on_coarse;

  Mesh() {
    for (int i = 0; i < size; ++i) {
      const double s = std::sin(pi * i / (2.0 * (size - 1)));
      at[i] = s * s;
    }
    Square values;
    for (int i = 0; i < size; ++i) values.row(i) = chebyshev(at[i]).transpose();
    to_coefficients = values.inverse();
    for (int i = 0; i < 16; ++i) on_fine.row(i) = row(fine.at[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 8; ++i) on_coarse.row(i) = row(coarse.at[static_cast<std::size_t>(i)]);
    for (int i = 0; i < size; ++i) {  // Gauss on [0, τ_i], exact for the polynomials
      integral.row(i).setZero();
      for (int q = 0; q < 16; ++q) {
        const auto place = static_cast<std::size_t>(q);
        integral.row(i) += at[i] * fine.weight[place] * row(at[i] * fine.at[place]);
      }
    }
    slope = integral_inverse();
  }

  static Row chebyshev(double tau) {
    Row t;
    const double x = 2 * tau - 1;
    t[0] = 1, t[1] = x;
    for (int k = 2; k < size; ++k) t[k] = 2 * x * t[k - 1] - t[k - 2];
    return t;
  }
  /// Weights of the values at the points in the polynomial's value at τ.
  Eigen::Matrix<double, 1, size> row(double tau) const { return chebyshev(tau).transpose() * to_coefficients; }

 private:
  Square integral_inverse() const {
    Square derivatives;
    for (int i = 0; i < size; ++i) {
      const double x = 2 * at[i] - 1;
      Row t = chebyshev(at[i]), d;
      d[0] = 0, d[1] = 2;
      for (int k = 2; k < size; ++k) d[k] = 4 * t[k - 1] + 2 * x * d[k - 1] - d[k - 2];
      derivatives.row(i) = d.transpose();
    }
    return derivatives * to_coefficients;
  }
};

const Mesh& mesh() {
  static const Mesh shared;
  return shared;
}

/// (I^β f)(τ_i) on one panel of length 1, from the values of f: Gauss's rule for the weight (1−σ)^{β−1} by the
/// eigenvalues of its Jacobi matrix (Golub and Welsch), its weights summing to 1, so that it stays regular as β → 0.
Square own_panel(double beta) {
  const double a = beta - 1;
  VectorXd diagonal(size), beside(size - 1);
  diagonal[0] = -a / (a + 2);
  for (int k = 1; k < size; ++k) {
    const double n = 2.0 * k + a;
    diagonal[k] = -a * a / (n * (n + 2));
    // k²(k+a)² 4/((n)²(n+1)(n−1)); at k = 1 the factor 1+a is common to both
    const double off = k == 1 ? 4 * (1 + a) / ((2 + a) * (2 + a) * (3 + a))
                              : 4.0 * k * k * (k + a) * (k + a) / (n * n * (n + 1) * (n - 1));
    beside[k - 1] = std::sqrt(off);
  }
  Eigen::SelfAdjointEigenSolver<MatrixXd> solved;
  solved.computeFromTridiagonal(diagonal, beside);
  Square result = Square::Zero();
  for (int i = 0; i < size; ++i)
    for (int q = 0; q < size; ++q) {
      const double first = solved.eigenvectors()(0, q), sigma = 0.5 * (1 + solved.eigenvalues()[q]);
      result.row(i) += first * first * mesh().row(mesh().at[i] * sigma);
    }
  for (int i = 0; i < size; ++i) result.row(i) *= std::pow(mesh().at[i], beta) / std::tgamma(beta + 1);
  return result;
}

struct MemoryPanel {
  double begin, length;
  double integral;        // of P
  Row f, slowed, memory;  // P(x), 1 − x' and (I^{1−α} − I)P at the points
  Eigen::Matrix<double, 16, 1> fine;
  Eigen::Matrix<double, 8, 1> coarse;

  double value(const Row& values, double tau) const { return mesh().row(tau) * values; }
};

/// Where f falls to 0 on a panel at whose end it is no longer positive; the seam, where rounding has it there.
template <class F>
double fall(const F& f) {
  const double before = f(0), after = f(1);
  return before > 0 ? support::root(f, 0.0, 1.0, before, after) : 0;
}

class Collocation {
 public:
  explicit Collocation(const MemoryEquation& e)
      : e_(e), p_(e.hertzian ? 1.5 : 1), beta_(1 - e.alpha), log_gamma_(std::lgamma(beta_)), own_(own_panel(beta_)) {
    start();
  }

  Collision run();
  const std::vector<MemoryPanel>& panels() const { return panels_; }
  /// Before the first panel.
  MemoryMotion::Instant at_first(double t) const;
  /// κP + γ D^αP = (κ + γ) P + γ (D^α − 1) P: differences spoil the last term alone, whose sums are as small as α.
  Row forces(const MemoryPanel& panel) const {
    return (e_.spring + e_.pot) * panel.f + e_.pot / panel.length * (mesh().slope * panel.memory);
  }
  Row x_of(const MemoryPanel& panel) const {
    return panel.f.unaryExpr([this](double f) { return e_.hertzian ? std::cbrt(f) * std::cbrt(f) : f; });
  }

 private:
  double power(double x) const { return e_.hertzian ? x * std::sqrt(x) : x; }
  double power_slope(double x) const { return e_.hertzian ? 1.5 * std::sqrt(x) : 1; }
  double end() const { return panels_.empty() ? first_end : panels_.back().begin + panels_.back().length; }

  void start();
  double first_f(double t) const;
  double memory_of_first(double t) const;
  double memory_of(const MemoryPanel& panel, double t) const;
  const Square& adjacent(double ratio);
  Row memory(double begin, double length);
  bool advance(double length);
  void accept(const MemoryPanel& panel, const Row& x);
  /// (t^{−α}/Γ(1−α)) − 1
  double kernel(double t) const { return std::expm1(-e_.alpha * std::log(t) - log_gamma_); }
  double overlap(const MemoryPanel& panel, double tau) const { return panel.value(x_of(panel), tau); }
  std::optional<double> fallen(const MemoryPanel& panel, const Row& force) const;
  void look_for_peak(const MemoryPanel& panel, Collision& out) const;

  MemoryEquation e_;
  double p_, beta_, log_gamma_;
  Square own_;
  std::map<double, Square> adjacent_;
  double by_spring_ = 0, by_pot_ = 0;  // x = t (1 + load t/2 − by_spring t^{p+1} − by_pot t^{p+1−α})
  std::vector<MemoryPanel> panels_;
  double x_ = 0, integral_ = 0, memory_ = 0;  // x, ∫P and (I^{1−α} − I)P at the end of the last panel
  double next_ = 0;                           // length of a panel that will do next
  std::size_t evaluations_ = 0;
};

void Collocation::start() {
  const double t = first_end;
  const auto ratio = [](double from, double by) { return std::exp(std::lgamma(from) - std::lgamma(from + by)); };
  by_spring_ = e_.spring * ratio(p_ + 1, 2);
  by_pot_ = e_.pot * ratio(p_ + 1, 2 - e_.alpha);
  x_ = t * (1 - by_spring_ * std::pow(t, p_ + 1) - by_pot_ * std::pow(t, p_ + 1 - e_.alpha)) + 0.5 * e_.load * t * t;
  const auto integrated = [&](double beta) {
    const auto term = [&](double exponent) { return ratio(exponent + 1, beta) * std::pow(t, exponent + beta); };
    return term(p_) - p_ * by_spring_ * term(2 * p_ + 1) - p_ * by_pot_ * term(2 * p_ + 1 - e_.alpha) +
           0.5 * p_ * e_.load * term(p_ + 1);
  };
  integral_ = integrated(1);
  memory_ = integrated(beta_) - integral_;
}

double Collocation::first_f(double t) const {
  return std::pow(t, p_) * (1 - p_ * by_spring_ * std::pow(t, p_ + 1) - p_ * by_pot_ * std::pow(t, p_ + 1 - e_.alpha) +
                            0.5 * p_ * e_.load * t);
}

MemoryMotion::Instant Collocation::at_first(double t) const {
  const double q = p_ - e_.alpha, spring = by_spring_ * std::pow(t, p_ + 1), pot = by_pot_ * std::pow(t, q + 1);
  const double pot_force = e_.pot * std::exp(std::lgamma(p_ + 1) - std::lgamma(q + 1)) * std::pow(t, q);
  return {.overlap = t * (1 + 0.5 * e_.load * t - spring - pot),
          .rate = 1 + e_.load * t - (p_ + 2) * spring - (q + 2) * pot,
          .force = e_.spring * std::pow(t, p_) + pot_force,
          .slope = (p_ * e_.spring * std::pow(t, p_) + q * pot_force) / t};
}

/// ∫ kernel(t−s) P ds over [0, first_end]: halves towards its end down to the distance of t; the half at 0 in
/// the root of s.
double Collocation::memory_of_first(double t) const {
  const auto& rule = mesh().fine;
  double sum = 0, low = 0;
  while (low < first_end) {
    const double rest = first_end - low, high = rest < 2 * (t - first_end) ? first_end : low + 0.5 * rest;
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
      const double y = rule.at[q], s = low == 0 ? high * y * y : low + (high - low) * y;
      const double weight = rule.weight[q] * (low == 0 ? 2 * high * y : high - low);
      sum += weight * first_f(s) * kernel(t - s);
    }
    low = high;
  }
  return sum;
}

/// The same over a panel that is farther than its length, or nearly so.
double Collocation::memory_of(const MemoryPanel& panel, double t) const {
  double sum = 0;
  const double from_begin = t - panel.begin;
  const auto add = [&](const auto& rule, const auto& values) {
    for (std::size_t q = 0; q < rule.at.size(); ++q)
      sum += rule.weight[q] * values[static_cast<Index>(q)] * kernel(from_begin - panel.length * rule.at[q]);
  };
  if (from_begin > 4 * panel.length)
    add(mesh().coarse, panel.coarse);
  else
    add(mesh().fine, panel.fine);
  return sum * panel.length;
}

/// I^{1−α} of the panel before, `ratio` times as long, for a panel of length 1: halves towards the seam.
const Square& Collocation::adjacent(double ratio) {
  const auto [known, fresh] = adjacent_.try_emplace(ratio, Square::Zero());
  if (!fresh) return known->second;
  const auto& rule = mesh().fine;
  for (int i = 1; i < size; ++i) {
    const double distance = mesh().at[i];
    double near = 0;  // from the seam
    while (near < ratio) {
      const double far = std::min(ratio, near == 0 ? distance : 2 * near + distance);
      for (std::size_t q = 0; q < rule.at.size(); ++q) {
        const double off = near + (far - near) * rule.at[q];
        known->second.row(i) +=
            rule.weight[q] * (far - near) * std::pow(distance + off, beta_ - 1) * mesh().row(1 - off / ratio);
      }
      near = far;
    }
  }
  known->second /= std::tgamma(beta_);
  return known->second;
}

/// What all panels so far contribute at the points of the next; at its first that is known.
Row Collocation::memory(double begin, double length) {
  Row sum = Row::Zero();
  const std::size_t far = panels_.empty() ? 0 : panels_.size() - 1;
  for (std::size_t j = 0; j < far; ++j) {
    const MemoryPanel& panel = panels_[j];
    for (int i = 1; i < size; ++i) sum[i] += memory_of(panel, begin + length * mesh().at[i]);
  }
  if (!panels_.empty()) {
    const MemoryPanel& last = panels_.back();
    sum += std::pow(length, beta_) * (adjacent(last.length / length) * last.f) - Row::Constant(last.integral);
  }
  for (int i = 1; i < size; ++i) sum[i] += memory_of_first(begin + length * mesh().at[i]);
  sum[0] = memory_;
  return sum;
}

/// Solves for one more panel; false where it is too long.
bool Collocation::advance(double length) {
  const double begin = end(), fraction = std::pow(length, beta_);
  const Square& J = mesh().integral;
  const Row past = memory(begin, length);
  const Square slowing = e_.spring * length * J + e_.pot * fraction * own_;  // 1 − x' of this panel's P
  Row known = e_.pot * past + Row::Constant((e_.spring + e_.pot) * integral_);
  if (e_.load > 0) known -= e_.load * (Row::Constant(begin) + length * mesh().at);
  const Row straight = Row::Constant(x_) + length * (J * (Row::Ones() - known));
  const Square bending = length * J * slowing;
  Row x = straight, f;
  const double rate = 1 - known[0];
  for (int i = 0; i < size; ++i) x[i] = std::max(x_ + length * mesh().at[i] * rate, 1e-3 * x_);
  double last = 1;
  for (int trial = 0; trial < 12; ++trial) {
    f = x.unaryExpr([this](double v) { return power(v); });
    evaluations_ += size;
    const Row off = x + bending * f - straight;
    const Square newton =
        Square::Identity() + bending * x.unaryExpr([this](double v) { return power_slope(v); }).asDiagonal();
    const Row change = newton.partialPivLu().solve(off);
    x -= change;
    if (e_.hertzian && !(x.minCoeff() > 0)) return false;
    const double size_of = change.cwiseAbs().maxCoeff();
    last = size_of / x.cwiseAbs().maxCoeff();
    if (last < 1e-8) break;  // the method squares it once more
  }
  if (!(last < 1e-8)) return false;
  f = x.unaryExpr([this](double v) { return power(v); });
  const Row c = (mesh().to_coefficients * f).cwiseAbs();
  if (!(c[size - 1] + c[size - 2] <= 2e-14 * c.maxCoeff())) return false;
  // They fall like a power: at half the degree to some 1e-7 where the last are just small enough.
  const double halfway = (c[size / 2] + c[size / 2 + 1]) / c.maxCoeff();
  next_ = halfway < 1e-8 ? 2 * length : halfway < 1e-7 ? length : 0.5 * length;
  const Row integral = length * (J * f), memory = past + fraction * (own_ * f) - integral;
  accept({begin, length, integral[size - 1], f, known + slowing * f, memory, mesh().on_fine * f, mesh().on_coarse * f},
         x);
  return true;
}

void Collocation::accept(const MemoryPanel& panel, const Row& x) {
  panels_.push_back(panel);
  x_ = x[size - 1];
  integral_ += panel.integral;
  memory_ = panel.memory[size - 1];
}

void Collocation::look_for_peak(const MemoryPanel& panel, Collision& out) const {
  const Row force = forces(panel);
  Index top = 0;
  if (!(force.maxCoeff(&top) > out.max_force)) return;
  const double low = mesh().at[std::max<Index>(0, top - 1)], high = mesh().at[std::min<Index>(size - 1, top + 1)];
  const auto [tau, negative] =
      boost::math::tools::brent_find_minima([&](double where) { return -panel.value(force, where); }, low, high, 50);
  out.max_force = std::max(-negative, force[top]);
  out.time_max_force = panel.begin + panel.length * (-negative > force[top] ? tau : mesh().at[top]);
}

/// Where the force falls to 0 on a panel; under a load it may be back above by the panel's end.
std::optional<double> Collocation::fallen(const MemoryPanel& panel, const Row& force) const {
  const auto pushing = [&](double tau) { return panel.value(force, tau); };
  if (pushing(1) <= 0) return fall(pushing);
  Index least = 0;
  if (!(e_.load > 0) || force.minCoeff(&least) > 0) return std::nullopt;
  return support::root(pushing, 0.0, mesh().at[least], pushing(0), force[least]);
}

Collision Collocation::run() {
  Collision out;
  double length = first_end;
  bool turned = false;
  for (int trial = 0; trial < most_panels; ++trial) {
    if (!advance(length)) {
      length *= 0.5;
      if (length < 1e-14 * end()) break;
      continue;
    }
    const MemoryPanel& panel = panels_.back();
    const auto rate = [&](double tau) { return 1 - panel.value(panel.slowed, tau); };
    if (!turned && rate(1) < 0) {
      turned = true;
      const double tau = fall(rate);
      out.time_max_overlap = panel.begin + panel.length * tau;
      out.max_overlap = overlap(panel, tau);
    }
    const Row force = forces(panel);
    const auto tau = turned ? fallen(panel, force) : std::nullopt;
    look_for_peak(panel, out);
    if (tau) {
      out.status = CollisionStatus::ended_by_force;
      out.tcol = panel.begin + panel.length * *tau;
      out.en = -rate(*tau);
      out.overlap_end = overlap(panel, *tau);
      break;
    }
    constexpr double creeping = 1e4;
    if (e_.load > 0 && turned && (rate(1) > 0 || panel.begin > creeping)) break;
    length = next_;
  }
  out.evaluations = evaluations_;
  return out;
}

}  // namespace

Collision follow_memory(const MemoryEquation& equation) { return Collocation(equation).run(); }

struct MemoryMotion::Panels {
  explicit Panels(const MemoryEquation& equation) : motion(equation) {
    motion.run();
    for (const MemoryPanel& panel : motion.panels()) {
      const Row force = motion.forces(panel);
      overlap.push_back(motion.x_of(panel));
      forces.push_back(force);
      slope.push_back(mesh().slope * force / panel.length);
    }
  }

  Collocation motion;
  std::vector<Row> overlap = {}, forces = {}, slope = {};
};

MemoryMotion::MemoryMotion(const MemoryEquation& equation) : panels_(std::make_shared<const Panels>(equation)) {}

MemoryMotion::Instant MemoryMotion::at(double t) const {
  const auto& panels = panels_->motion.panels();
  if (t < first_end || panels.empty()) return panels_->motion.at_first(t);
  const auto after = std::upper_bound(panels.begin() + 1, panels.end(), t,
                                      [](double time, const MemoryPanel& panel) { return time < panel.begin; });
  const auto i = static_cast<std::size_t>(after - panels.begin()) - 1;
  const auto here = mesh().row((t - panels[i].begin) / panels[i].length);
  return {.overlap = here * panels_->overlap[i],
          .rate = 1 - here * panels[i].slowed,
          .force = here * panels_->forces[i],
          .slope = here * panels_->slope[i]};
}

}  // namespace ricochet::collision
