#include <ricochet/collision/solvers/sphere_elements.hpp>

#include <ricochet/support/require.hpp>

#include <cmath>
#include <limits>

namespace ricochet {
namespace {

/// An element: the depth at which it is touched, the mesh point at which it was, and its force for a last rate of 0.
struct Element {
  double depth;
  std::size_t touched;
  double force = 0;
};

/// ∫_a^b y^{−1/2} f dy of f that is linear from f_a to f_b.
double weighed(double a, double b, double f_a, double f_b) {
  if (b <= a) return 0;
  const double root_a = std::sqrt(a), root_b = std::sqrt(b), slope = (f_b - f_a) / (b - a);
  return (f_a - slope * a) * 2 * (root_b - root_a) + slope * (2.0 / 3) * (b * root_b - a * root_a);
}

class Elements {
 public:
  Elements(double alpha, const ElementMesh& mesh) : alpha_(alpha), mesh_(mesh) {}

  /// Approaches on a mesh of this length; the rate at its end.
  double approach(double length);
  /// Goes on from there until the last element leaves.
  SphereImpact go_back();
  double strength() const { return force_; }

 private:
  struct Step {
    double time, rate, overlap, force;
    double innermost;     ///< force of the first element
    std::size_t carried;  ///< of the cells between elements, those that still carry
  };

  Step step(double h);
  void accept(const Step& s);
  double remember(double now);
  double sum(double last_weight, double rate, double overlap, std::size_t& carried) const;

  double alpha_;
  ElementMesh mesh_;
  std::vector<double> time_, rate_, overlap_;
  std::vector<Element> elements_;
  double force_ = 0;
  bool turned_ = false;
  std::size_t carried_ = 0;
};

/// Every element's ∫ (now−s)^{−α} ζ' ds / Γ(1−α) since it was touched, summed from the newest step to the oldest, but
/// for what the rate at `now` adds: that times the weight returned.
double Elements::remember(double now) {
  const double first = 1 / std::tgamma(2 - alpha_), second = (1 - alpha_) / std::tgamma(3 - alpha_);
  std::size_t waiting = elements_.size();
  double young = 0, young_power = 0, total = 0, last_weight = 0;
  for (std::size_t l = time_.size(); l-- > 0;) {
    const double old = now - time_[l], old_power = std::pow(old, 1 - alpha_);
    const double whole = first * (old_power - young_power);
    const double at_old =
        (second * (old * old_power - young * young_power) - first * young * (old_power - young_power)) / (old - young);
    if (l + 1 == time_.size())
      last_weight = whole - at_old;
    else
      total += (whole - at_old) * rate_[l + 1];
    total += at_old * rate_[l];
    for (; waiting > 0 && elements_[waiting - 1].touched == l; --waiting) elements_[waiting - 1].force = total;
    young = old;
    young_power = old_power;
  }
  return last_weight;
}

/// 2∫f dx = (3/4) ∫ y^{−1/2} f dy over the elements that carry; an edge between two of them is where f, linear, is 0.
double Elements::sum(double last_weight, double rate, double overlap, std::size_t& carried) const {
  const auto force_of = [&](std::size_t j) { return elements_[j].force + last_weight * rate; };
  double total = 0;
  const std::size_t cells = turned_ ? carried_ : elements_.size() - 1;
  carried = 0;
  for (std::size_t j = 0; j < cells; ++j) {
    const double a = elements_[j].depth, b = elements_[j + 1].depth, f_a = force_of(j), f_b = force_of(j + 1);
    if (turned_ && f_a <= 0) break;
    carried = j + 1;
    if (turned_ && f_b < 0) {
      total += weighed(a, a + (b - a) * f_a / (f_a - f_b), f_a, 0);
      break;
    }
    total += weighed(a, b, f_a, f_b);
  }
  if (!turned_) total += weighed(elements_.back().depth, overlap, force_of(elements_.size() - 1), 0);
  return 0.75 * total;
}

Elements::Step Elements::step(double h) {
  const double last_weight = remember(time_.back() + h);
  Step s{.time = time_.back() + h,
         .rate = rate_.back() - h * force_,
         .overlap = 0,
         .force = force_,
         .innermost = 0,
         .carried = 0};
  constexpr int most = 50;
  for (int k = 0; k < most; ++k) {
    s.overlap = overlap_.back() + 0.5 * h * (rate_.back() + s.rate);
    s.force = sum(last_weight, s.rate, s.overlap, s.carried);
    const double next = rate_.back() - 0.5 * h * (force_ + s.force), change = std::abs(next - s.rate);
    s.rate = next;
    if (change <= std::numeric_limits<double>::epsilon()) break;
  }
  s.innermost = elements_.front().force + last_weight * s.rate;
  return s;
}

void Elements::accept(const Step& s) {
  time_.push_back(s.time);
  rate_.push_back(s.rate);
  overlap_.push_back(s.overlap);
  force_ = s.force;
  if (turned_) carried_ = s.carried;
}

double Elements::approach(double length) {
  time_ = {0};
  rate_ = {1};
  overlap_ = {0};
  elements_ = {{0, 0}};
  force_ = 0;
  for (int n = 1; n <= mesh_.steps; ++n) {
    const double part = static_cast<double>(n) / mesh_.steps;
    accept(step(length * part * part - time_.back()));
    if (n % mesh_.every == 0) elements_.push_back({overlap_.back(), static_cast<std::size_t>(n)});
  }
  return rate_.back();
}

SphereImpact Elements::go_back() {
  turned_ = true;
  carried_ = elements_.size() - 1;
  SphereImpact out{
      .en = 0, .tcol = 0, .max_overlap = overlap_.back(), .time_max_overlap = time_.back(), .overlap_end = 0};
  const double h = time_.back() / mesh_.steps;
  for (double before = 1;;) {
    const Step s = step(h);
    if (s.innermost <= 0) {
      const double part = before / (before - s.innermost) * h;  // of this step
      out.tcol = time_.back() + part;
      out.en = -(rate_.back() - 0.4 * force_ * part);  // the force ends as (t_e − t)^{3/2}
      out.overlap_end = overlap_.back() - out.en * part;
      return out;
    }
    before = s.innermost;
    accept(s);
  }
}

}  // namespace

SphereImpact impact_by_elements(double alpha, const ElementMesh& mesh) {
  support::require(alpha >= 0 && alpha <= 0.8, "alpha", alpha, "in [0, 0.8]");
  support::require(mesh.steps >= 8 && mesh.steps <= 8192, "steps", mesh.steps, "in [8, 8192]");
  support::require(mesh.every >= 1 && mesh.steps % mesh.every == 0, "every", mesh.every, "a divisor of steps");
  Elements elements(alpha, mesh);
  double a = 1.6, at_a = elements.approach(a);
  double b = a + at_a / elements.strength();
  for (int k = 0; k < 20; ++k) {
    const double at_b = elements.approach(b);
    if (std::abs(at_b) < 1e-13) break;
    const double next = b - at_b * (b - a) / (at_b - at_a);
    a = b;
    at_a = at_b;
    b = next;
  }
  return elements.go_back();
}

ElementsLimit limit_by_elements(double alpha, double tolerance) {
  support::require_positive("tolerance", tolerance);
  constexpr int coarsest = 32, finest = 2048;
  const auto without = [](double coarse, double fine, double order) {
    return fine + (fine - coarse) / (std::exp2(order) - 1);
  };
  ElementsLimit out{
      .steps = {}, .en = {}, .without = {}, .limit = {}, .doubt = std::numeric_limits<double>::infinity()};
  for (int steps = coarsest; steps <= finest && out.doubt > tolerance; steps *= 2) {
    out.steps.push_back(steps);
    out.en.push_back(impact_by_elements(alpha, {.steps = steps}).en);
    const std::size_t n = out.en.size();
    if (n >= 2) out.without.push_back(without(out.en[n - 2], out.en[n - 1], 2 - alpha));
    if (n >= 3) out.limit.push_back(without(out.without[n - 3], out.without[n - 2], 2));
    if (n >= 4) out.doubt = std::abs(out.limit[n - 3] - out.limit[n - 4]);
  }
  return out;
}

}  // namespace ricochet
