#include "solution.hpp"

#include <nlopt.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ricochet::calibration {
namespace {

using Point = std::array<double, 2>;

/// The misses of one collision; both logarithmic, so that neither a small e_n nor one close to 1 weighs less.
struct Residual {
  double tcol, loss;
  double squared() const { return tcol * tcol + loss * loss; }
};

/// The search's view of the problem, and the best point it has seen.
class Problem {
 public:
  Problem(const Request& request, double load)
      : request_(request), target_loss_(-std::log(request.target.en)), load_(load) {
    if (request.law == kind_of<FractionalZener>) most_ = Reduction<FractionalZener>::lossiest(request.held);
  }

  /// 2 unknowns; the elastic law has the stiffness alone.
  unsigned unknowns() const { return target_loss_ > 0 ? 2 : 1; }
  const Point& best() const { return best_; }
  double best_value() const { return best_value_; }
  std::size_t evaluations() const { return evaluations_; }

  Coordinates coordinates(const Point& x) const {
    return {x[0], unknowns() == 2 ? x[1] : -std::numeric_limits<double>::infinity()};
  }

  double value(const Point& x) {
    const double f = residual(x).squared();
    if (f < best_value_) {
      best_value_ = f;
      best_ = x;
    }
    return f;
  }

  /// 2 Jᵀr with the Jacobian by central differences: its error, of order step², vanishes against r as r → 0.
  void gradient(const Point& x, double* out) {
    constexpr double step = 1e-4;
    const Residual r = residual(x);
    for (unsigned i = 0; i < unknowns(); ++i) {
      Point ahead = x, behind = x;
      ahead[i] += step;
      behind[i] -= step;
      const Residual a = residual(ahead), b = residual(behind);
      out[i] = (r.tcol * (a.tcol - b.tcol) + r.loss * (a.loss - b.loss)) / step;
    }
  }

 private:
  Residual residual(const Point& x) {
    ++evaluations_;
    // Beyond e^40 no target needs the parameters: a step that far is a runaway, and exp would overflow later.
    if (std::abs(x[0]) > 40 || std::abs(x[1]) > 40) return {100, 100};
    if (x[1] > most_) return {50, 50 + x[1]};
    const auto out = unit_collision(request_, coordinates(x), load_);
    if (!out.separated() || out.en <= 0) return {50, 50 + x[1]};  // less loss is the way back
    return {std::log(out.tcol), unknowns() == 1 ? 0 : loss_residual(-std::log(out.en))};
  }

  /// Close to e = 1 the rounding of the collision hides the last digits of ln e: within them there is nothing to tell
  /// one point from another, and a search that tried would lose the collision time in the noise.
  double loss_residual(double loss) const {
    constexpr double rounding = 2e-14;
    if (std::abs(loss - target_loss_) <= rounding) return 0;
    return std::log(std::max(loss, 1e-300) / target_loss_);
  }

  const Request& request_;
  double target_loss_, load_;
  double most_ = std::numeric_limits<double>::infinity();  // past it the law loses less again
  std::size_t evaluations_ = 0;
  Point best_{0, 0};
  double best_value_ = std::numeric_limits<double>::max();
};

double objective(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  auto& problem = *static_cast<Problem*>(data);
  const Point point{x[0], x.size() == 2 ? x[1] : 0};
  if (!gradient.empty()) problem.gradient(point, gradient.data());
  return problem.value(point);
}

/// One run from the best point so far. NLopt reports its limits of rounding and its failures by exceptions; what counts
/// here is only the best point, which the problem keeps.
void run(Problem& problem, nlopt::algorithm algorithm, double step, double goal) {
  nlopt::opt optimizer(algorithm, problem.unknowns());
  optimizer.set_min_objective(objective, &problem);
  optimizer.set_stopval(goal);
  optimizer.set_xtol_rel(1e-15);
  optimizer.set_maxeval(400);
  optimizer.set_initial_step(step);
  std::vector<double> x(problem.best().begin(), problem.best().begin() + problem.unknowns());
  double f = 0;
  try {
    optimizer.optimize(x, f);
  } catch (const nlopt::roundoff_limited&) {
  } catch (const std::runtime_error&) {
  }
}

}  // namespace

const std::vector<std::string>& algorithms() {
  static const std::vector<std::string> names{"LN_BOBYQA", "LN_NELDERMEAD", "LN_SBPLX", "LD_SLSQP"};
  return names;
}

Solution search(const Request& request, const std::string& algorithm, double tolerance, double load) {
  Problem problem(request, load);
  const auto chosen = static_cast<nlopt::algorithm>(nlopt_algorithm_from_string(algorithm.c_str()));
  // A residual of `tolerance` in ln t is one of t; in ln ln e it is one of ln e, so |ln e| times that of e.
  const double miss = 0.01 * tolerance / std::max(1.0, -std::log(request.target.en));
  // A run that ends early (its trust region or simplex has shrunk) is begun anew around its best point, until one gains
  // nothing: then rounding is all that is left.
  double step = 1, previous = std::numeric_limits<double>::infinity();
  while (problem.best_value() > miss * miss && problem.best_value() < 0.25 * previous) {
    previous = problem.best_value();
    run(problem, chosen, step, miss * miss);
    step = std::clamp(std::sqrt(problem.best_value()), 1e-10, 1.0);
  }
  return {scaled_law(request.law, problem.coordinates(problem.best()), request.held), algorithm, problem.evaluations()};
}

}  // namespace ricochet::calibration
