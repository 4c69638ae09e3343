#include "kernel_fit.hpp"

#include <ricochet/fractional/decay_moments.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace ricochet::fractional {

namespace {

using Real = KernelFit::Real;
using Vector = KernelFit::Vector;

/// Solves a·y = b into b; `a` is square, row-major, and overwritten. False if it is singular.
bool solve(Vector& a, Vector& b) {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(b.size());
  Eigen::Map<Matrix> matrix(a.data(), n, n);
  Eigen::Map<Eigen::Vector<Real, Eigen::Dynamic>> right(b.data(), n);
  right = Eigen::PartialPivLU<Eigen::Ref<Matrix>>(matrix).solve(right);
  return right.allFinite();
}

Real largest(const Vector& v, std::size_t count) {
  Real m = 0;
  for (std::size_t i = 0; i < count; ++i) m = std::max(m, std::fabs(v[i]));
  return m;
}

/// Past this x, e^{−x} t^α c is nothing to a sum near 1, whatever t ≤ 1e6 and strength c.
constexpr Real negligible = 64;

/// Residuals of `meet` and their Jacobian: they share the exponentials, which are the whole cost.
class Conditions {
 public:
  Conditions(Real alpha, const Vector& points, bool level_free)
      : alpha_(alpha), points_(points), level_free_(level_free) {
    for (const Real t : points) weight_.push_back(std::pow(t, alpha));
  }
  std::size_t size() const { return points_.size() + 1; }

  Vector residual(const Vector& x, Real level, Vector& jacobian) const {
    const std::size_t n = x.size() / 2, size = this->size();
    Vector r(size);
    jacobian.assign(size * size, 0);
    Vector c(n), s(n);
    for (std::size_t j = 0; j < n; ++j) c[j] = std::exp(x[1 + j]), s[j] = std::exp(x[1 + n + j]);
    const Real spring = std::exp(x[0]);
    for (std::size_t i = 0; i + 1 < size; ++i) {
      const Real t = points_[i], w = weight_[i], sign = i % 2 ? -1 : 1;
      Real* row = &jacobian[i * size];
      Real sum = w * spring;
      row[0] = sum;
      for (std::size_t j = 0; j < n; ++j) {
        if (s[j] * t > negligible) continue;
        const Real e = w * c[j] * std::exp(-s[j] * t);
        sum += e;
        row[1 + j] = e, row[1 + n + j] = -e * s[j] * t;
      }
      if (level_free_) row[size - 1] = sign;
      r[i] = 1 - sum - sign * level;
    }
    const Real scale = 2 - alpha_;
    Real* row = &jacobian[(size - 1) * size];
    Real sum = 0.5L * scale * spring;
    row[0] = sum;
    for (std::size_t j = 0; j < n; ++j) {
      const auto m = decay_moments(s[j]);
      const Real part = scale * c[j] * m.rising;
      sum += part;
      row[1 + j] = part, row[1 + n + j] = -scale * c[j] * s[j] * m.rising_twice;
    }
    r[size - 1] = 1 - sum;
    return r;
  }

 private:
  Real alpha_;
  const Vector& points_;
  bool level_free_;
  Vector weight_;
};

}  // namespace

void KernelFit::take(Vector log_unknowns) {
  x_ = std::move(log_unknowns);
  rate_.clear();
  for (std::size_t j = 0; j < arms(); ++j) rate_.push_back(std::exp(x_[1 + arms() + j]));
}

Real KernelFit::deviation(Real t) const {
  Real sum = spring();
  for (std::size_t j = 0; j < arms(); ++j)
    if (const Real decay = rate(j) * t; decay <= negligible) sum += std::exp(x_[1 + j] - decay);
  return 1 - sum * std::pow(t, alpha_);
}

Real KernelFit::impulse() const {
  Real sum = spring();
  for (std::size_t j = 0; j < arms(); ++j) sum += strength(j) * decay_mean(rate(j));
  return sum;
}

bool KernelFit::meet(const Vector& points, Real& level, Real tolerance) {
  const std::size_t n = x_.size();
  const bool level_free = points.size() == n;
  const Conditions conditions(alpha_, points, level_free);
  Vector x = x_, jacobian, next_jacobian;
  Real e = level;
  Vector step = conditions.residual(x, e, jacobian);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Real before = largest(step, step.size());
    if (before <= tolerance) {
      take(std::move(x));
      level = e;
      return true;
    }
    if (!solve(jacobian, step)) return false;
    // No unknown may change by more than a factor of e at once, and the residual has to fall.
    Real length = std::min<Real>(1, 1 / largest(step, n));
    for (int halving = 0;; ++halving, length /= 2) {
      Vector y = x;
      for (std::size_t i = 0; i < n; ++i) y[i] += length * step[i];
      const Real f = level_free ? e + length * step[n] : e;
      Vector r = conditions.residual(y, f, next_jacobian);
      if (largest(r, r.size()) < before) {
        x = std::move(y);
        e = f;
        step = std::move(r);
        std::swap(jacobian, next_jacobian);
        break;
      }
      if (halving == 12) return false;
    }
  }
  return false;
}

KernelFit::Waves KernelFit::waves(Real ratio) const {
  const std::size_t samples = 12 * (2 * arms() + 2);
  const Real span = std::log(ratio);
  Vector u(samples + 1), v(samples + 1);
  for (std::size_t i = 0; i <= samples; ++i) {
    const Real p = static_cast<Real>(i) / samples;
    u[i] = span * (0.25L * (1 - std::cos(pi * p)) + 0.5L * p);  // the waves are a little denser at both ends
    v[i] = deviation(std::exp(u[i]));
  }
  Waves found;
  found.lowest = HUGE_VALL;
  for (std::size_t start = 0, i = 1; i <= samples + 1; ++i) {
    if (i <= samples && (v[i] > 0) == (v[start] > 0)) continue;
    std::size_t k = start;
    for (std::size_t j = start; j < i; ++j)
      if (std::fabs(v[j]) > std::fabs(v[k])) k = j;
    Real at = u[k], height = std::fabs(v[k]);
    if (k > 0 && k < samples) {  // the parabola through three samples
      const Real left = (v[k] - v[k - 1]) / (u[k] - u[k - 1]), right = (v[k + 1] - v[k]) / (u[k + 1] - u[k]);
      const Real curve = (right - left) / (u[k + 1] - u[k - 1]);
      at = std::clamp(0.5L * (u[k - 1] + u[k]) - left / (2 * curve), u[k - 1], u[k + 1]);
      height = std::max(height, std::fabs(deviation(std::exp(at))));
    }
    found.extrema.push_back(std::exp(at));
    found.highest = std::max(found.highest, height);
    found.lowest = std::min(found.lowest, height);
    if (i <= samples) found.zeros.push_back(std::exp(u[i - 1] + (u[i] - u[i - 1]) * v[i - 1] / (v[i - 1] - v[i])));
    start = i;
  }
  return found;
}

namespace {

/// The sample of v at real position p, linear between and beyond its entries.
Real stretched(const Real* v, std::size_t count, Real p) {
  if (count == 1) return v[0];
  const auto k = static_cast<std::size_t>(std::clamp<Real>(std::floor(p), 0, static_cast<Real>(count - 2)));
  const Real w = p - static_cast<Real>(k);
  return v[k] * (1 - w) + v[k + 1] * w;
}

/// Place i of n equal cells, counted in those of m.
Real place(std::size_t i, std::size_t n, std::size_t m) {
  return (static_cast<Real>(i) + 0.5L) / static_cast<Real>(n) * static_cast<Real>(m) - 0.5L;
}

/// 2n points like the old ones: these as a function of their number, in the angle that undoes the clustering at both
/// ends, where they continue by reflection.
Vector denser_points(const Vector& old, std::size_t n, Real ratio) {
  const Real span = std::log(ratio);
  const std::size_t m = old.size();
  Vector angle(m + 2);
  for (std::size_t i = 0; i < m; ++i) angle[i + 1] = std::acos(1 - 2 * std::log(old[i]) / span);
  angle[0] = -angle[1];
  angle[m + 1] = 2 * pi - angle[m];
  Vector points(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i)
    points[i] = std::exp(span * 0.5L * (1 - std::cos(stretched(angle.data(), m + 2, place(i, 2 * n, m) + 1))));
  return points;
}

/// A guess with n arms: strengths and rates of fewer as functions of their number, thinned out, the spring by `ease`.
Vector more_arms(const Vector& x, std::size_t n, Real ease) {
  const std::size_t m = x.size() / 2;
  const Real thinner = std::log(static_cast<Real>(m) / static_cast<Real>(n));
  Vector y(2 * n + 1);
  y[0] = x[0] - ease;
  for (std::size_t j = 0; j < n; ++j) {
    y[1 + j] = stretched(&x[1], m, place(j, n, m)) + thinner;
    y[1 + n + j] = m == 1 ? x[2] + (j == 0 ? -1.5L : 1.5L) : stretched(&x[1 + m], m, place(j, n, m));
  }
  return y;
}

/// Grows a sum by arms and by memory, each solution starting the next.
class Growth {
 public:
  Growth(Real alpha, Real tolerance)
      // All that is not spring is of order α: what Newton leaves over must be small against that too.
      : newton_tolerance_(std::max(1e-17L, 1e-4L * std::min(tolerance, alpha))),
        fit_(alpha, {std::log(0.5L * std::pow(ratio_, -alpha)), 0, 0}),
        points_{std::pow(ratio_, 0.1464L), std::pow(ratio_, 0.8536L)} {
    interpolate(fit_, points_, ratio_);
    level_waves(1.02L, 8);
    while (fit_.arms() < 3 && grow(1)) {
    }
  }

  const KernelFit& fit() const { return fit_; }
  std::size_t arms() const { return fit_.arms(); }
  Real ratio() const { return ratio_; }
  Real highest() const { return highest_; }
  Real lowest() const { return lowest_; }

  bool grow(std::size_t more) {
    const std::size_t n = fit_.arms() + more;
    const Vector points = denser_points(points_, n, ratio_);
    bool met = false;  // Newton's method may wander off from one guess and not from its neighbour
    for (const Real ease : {0.1L, 0.0L, 0.05L, 0.3L, 0.02L, 0.2L, 0.5L})
      if ((met = interpolate(KernelFit(fit_.alpha(), more_arms(fit_.unknowns(), n, ease)), points, ratio_))) break;
    if (!met) return false;
    // Below, interpolation carries the points on well, and the exchange would be at the mercy of rounding.
    if (highest_ > 1e-8L) level_waves(1.1L, 2);
    return true;
  }

  bool widen(Real ratio) {
    const Real stretch = std::log(ratio) / std::log(ratio_);
    Vector points = points_;
    for (Real& t : points) t = std::pow(t, stretch);
    if (!interpolate(fit_, points, ratio)) return false;
    level_waves(1.1L, 4);
    return true;
  }

  /// Remez exchange towards waves of one height; keeps the last good sum.
  void level_waves(Real even, int rounds) {
    while (rounds-- > 0 && highest_ > even * lowest_) {
      KernelFit trial = fit_;
      const Vector extrema = trial.waves(ratio_).extrema;
      if (extrema.size() != points_.size() + 1) return;
      Real level = std::copysign(highest_, trial.deviation(extrema[0]));
      if (!trial.meet(extrema, level, std::max(1e-3L * highest_, newton_tolerance_))) return;
      const KernelFit::Waves waves = trial.waves(ratio_);
      if (waves.zeros.size() != points_.size() || waves.highest >= highest_) return;
      keep(std::move(trial), waves.zeros, waves, ratio_);
    }
  }

 private:
  bool interpolate(KernelFit guess, Vector points, Real ratio) {
    Real level = 0;
    if (!guess.meet(points, level, newton_tolerance_)) return false;
    const KernelFit::Waves waves = guess.waves(ratio);
    keep(std::move(guess), std::move(points), waves, ratio);
    return true;
  }

  void keep(KernelFit fit, Vector points, const KernelFit::Waves& waves, Real ratio) {
    fit_ = std::move(fit);
    points_ = std::move(points);
    ratio_ = ratio;
    highest_ = waves.highest;
    lowest_ = waves.lowest;
  }

  Real newton_tolerance_;
  Real ratio_ = 10;
  KernelFit fit_;
  Vector points_;  // where the sum meets the kernel
  Real highest_ = 0, lowest_ = 0;
};

}  // namespace

KernelFit fit_kernel(Real alpha, Real ratio, Real tolerance, std::size_t max_arms) {
  Growth sum(alpha, tolerance);
  while (sum.ratio() < ratio && sum.widen(std::min(ratio, 1.5L * sum.ratio()))) {
  }
  for (Real before = 0;;) {
    if (sum.highest() > tolerance && sum.lowest() < tolerance) sum.level_waves(1.001L, 8);
    if (sum.highest() <= tolerance || sum.arms() == max_arms) return sum.fit();
    // The error falls by about the same factor with every arm: far from the goal several may come at once.
    const Real gain = before > 0 ? before / sum.highest() : 1;
    const Real missing = gain > 1 ? 0.8L * std::log(sum.highest() / tolerance) / std::log(gain) : 1;
    const std::size_t most = sum.arms() / 5 + 1;
    auto more = static_cast<std::size_t>(std::clamp<Real>(missing, 1, static_cast<Real>(most)));
    before = sum.highest();
    bool grown = false;
    for (const std::size_t step : {more, std::size_t{1}, std::size_t{2}, std::size_t{3}})
      if (sum.arms() + step <= max_arms && (grown = sum.grow(more = step))) break;
    if (!grown) return sum.fit();
    before = sum.highest() * std::pow(before / sum.highest(), 1 / static_cast<Real>(more));
  }
}

}  // namespace ricochet::fractional
