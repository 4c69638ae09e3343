#include "solids.hpp"

#include <console/exit.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/solvers/hertzian_forms.hpp>
#include <ricochet/collision/solvers/solid_series.hpp>
#include <ricochet/motion/column.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

namespace {

constexpr Impact unit{.velocity = 1, .mass_eff = 1};
constexpr int offsets = 16;           // places of the first touch in a step
constexpr std::size_t fewest = 16;    // steps a collision: less is past what the column bears
constexpr std::size_t finest = 1024;  // kernels get no more arms than a contact carries

// The laws that are run, with k = 1.
FractionalKelvinVoigt voigt(double alpha) { return {1, 0.5, alpha}; }
FractionalZener zener(double alpha) { return {1, 4, 0.2, alpha}; }
FractionalHertz hertz(double alpha) { return {1, 2, alpha}; }

constexpr const char* without_near_orders = "e_n less near orders";

template <class Law>
std::string in_column() {
  return fmt::format("{} in a column", Law::name);
}

template <class Law>
std::string by(const char* method) {
  return fmt::format("{} by {}", Law::name, method);
}

/// Means over where in a step a bead touches the plate: of the error of e_n, and of its size.
struct Means {
  double error = 0, size = 0, worst = 0;
};

template <class Law>
Means bead_on_plate(const Law& law, const Collision& truth, std::size_t steps) {
  const double h = truth.tcol / static_cast<double>(steps);
  const MemoryKernel kernel = affordable_kernel(law.alpha(), {h, 1.3 * truth.tcol, 1e-10}, Law::Arms::max_kernel_arms);
  const typename Law::Arms arms(law, kernel, h);
  Means means;
  for (int k = 0; k < offsets; ++k) {
    const Column column = equal_column(1, 1, (1 + static_cast<double>(k) / offsets) * h, -1);
    const ColumnResult r = run_column(column, arms, arms, {.step = h, .duration = 4 * truth.tcol});
    const double error = r.velocity.empty() ? std::nan("") : r.velocity[0] / truth.en - 1;
    means.error += error / offsets;
    means.size += std::fabs(error) / offsets;
    means.worst = std::fabs(error) > means.worst || std::isnan(error) ? std::fabs(error) : means.worst;
  }
  return means;
}

/// Stated: 2, with a term of order 3 − α beside it, as the product trapezoid rule has.
template <class Law>
Convergence stepped(const Law& law, const std::vector<std::size_t>& steps) {
  const Collision truth = collide(law, unit);
  const double gap = 1 - law.alpha();
  Convergence c{.statement = {in_column<Law>(), "e_n", law.alpha(), 2.0, gap < 0.5 ? 0.15 : 0.1},
                .rounding = 1e-9,  // of the kernel
                .length = truth.tcol};
  for (const std::size_t n : steps) {
    const Means m = bead_on_plate(law, truth, n);
    c.steps.push_back(n);
    c.values.push_back(m.error);
    c.errors.push_back(m.size);
    c.worst.push_back(m.worst);
  }
  return c;
}

/// The errors without their term of that order, by each two meshes.
void take_out(Convergence& c, double order) {
  for (std::size_t i = 0; i + 1 < c.steps.size(); ++i) {
    const double gain = std::pow(static_cast<double>(c.steps[i + 1]) / static_cast<double>(c.steps[i]), order);
    c.values[i] = (gain * c.values[i + 1] - c.values[i]) / (gain - 1);
    c.errors[i] = std::fabs(c.values[i]);
  }
  for (auto* list : {&c.values, &c.errors}) list->pop_back();
  c.steps.pop_back();
  c.worst.clear();
}

/// Hertz's memory is stretched by ζ^{3/2}, of whose rate t^{1/2} the first steps know the means: a term of order 5/2 −
/// α stands beside 2. So does 5/2 where little is lost, α < 1/2, and the contact ends near ζ = 0. Of either sign and so
/// near, they are taken out; what is left is of order 2, with what is half an order higher beside it.
Convergence stepped_hertz(const FractionalHertz& law, const std::vector<std::size_t>& steps) {
  Convergence c = stepped(law, steps);
  c.statement.function = without_near_orders;
  c.statement.allowed = 0.15;
  const double start = 2.5 - law.alpha();
  if (std::fabs(start - 2) > 0.05) take_out(c, start);
  if (start > 2) take_out(c, 2.5);
  return c;
}

Convergence exactly(const std::string& scheme, double alpha, int nodes, double tcol, double en,
                    const Collision& truth) {
  const double error = std::max(std::fabs(tcol / truth.tcol - 1), std::fabs(en / truth.en - 1));
  return {.statement = {scheme, "t_col, e_n", alpha, std::nullopt, 0.1},
          .steps = {static_cast<std::size_t>(nodes)},
          .errors = {error},
          .values = {error},
          .length = 0};
}

bool has_series(double alpha) { return std::fabs(100 * alpha - std::round(100 * alpha)) <= 1e-12; }

/// The second ways of one α.
std::vector<Convergence> second_ways(double alpha) {
  std::vector<Convergence> all;
  const Collision v = collide(voigt(alpha), unit), z = collide(zener(alpha), unit);
  const Collision panels = collide(voigt(alpha), unit, {.method = CollideMethod::numerical});
  all.push_back(exactly(by<FractionalKelvinVoigt>("collocation"), alpha, 16, panels.tcol, panels.en, v));
  if (has_series(alpha)) {
    const SeriesRebound of_v = series_rebound(voigt(alpha)), of_z = series_rebound(zener(alpha));
    all.push_back(exactly(by<FractionalKelvinVoigt>("series"), alpha, of_v.terms, of_v.tcol, of_v.en, v));
    all.push_back(exactly(by<FractionalZener>("series"), alpha, of_z.terms, of_z.tcol, of_z.en, z));
  }
  if (alpha >= 0.1 && alpha <= 0.8) {  // of k = 0, where its series has no circle to leave
    const HertzianRebound of_h = hertzian_rebound(HertzianForm::derivative_of_power, alpha);
    const Collision h = collide(FractionalHertz(0, 1, alpha), unit);
    all.push_back(exactly(by<FractionalHertz>("series"), alpha, of_h.terms, of_h.tcol, of_h.en, h));
  }
  return all;
}

}  // namespace

std::vector<std::string> solid_schemes() {
  return {by<FractionalKelvinVoigt>("collocation"),
          by<FractionalKelvinVoigt>("series"),
          by<FractionalZener>("series"),
          by<FractionalHertz>("series"),
          in_column<FractionalKelvinVoigt>(),
          in_column<FractionalZener>(),
          in_column<FractionalHertz>()};
}

std::vector<Convergence> measure_solids(const Selection& wanted) {
  std::vector<Convergence> all;
  const auto want = [&](const std::string& scheme) { return wanted.scheme(scheme); };
  const std::vector<std::size_t> steps = wanted.steps(finest);
  if ((want(in_column<FractionalKelvinVoigt>()) || want(in_column<FractionalZener>()) ||
       want(in_column<FractionalHertz>())) &&
      steps.front() < fewest)
    throw console::BadInput("--steps", std::to_string(steps.front()),
                            fmt::format("at least {} for a bead in a column", fewest));
  for (const double alpha : wanted.alphas()) {
    for (Convergence& c : second_ways(alpha))
      if (want(c.statement.scheme)) all.push_back(std::move(c));
    if (want(in_column<FractionalKelvinVoigt>())) all.push_back(stepped(voigt(alpha), steps));
    if (want(in_column<FractionalZener>())) all.push_back(stepped(zener(alpha), steps));
    if (want(in_column<FractionalHertz>())) all.push_back(stepped_hertz(hertz(alpha), wanted.steps(2 * finest)));
  }
  return all;
}

}  // namespace ricochet::verify
