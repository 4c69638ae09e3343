#include <verify/registry.hpp>

#include "../convergence.hpp"
#include "kernel_table.hpp"
#include "../solvers.hpp"

#include <console/number.hpp>
#include <ricochet/fractional/collocation.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

namespace {

/// Largest error over all nodes for f = t^{3/2} on graded meshes: uniform ones lose the start, graded ones don't.
/// grading 0 stands for the one that restores the rule's order.
Convergence graded(bool l1, double alpha, bool restored) {
  const double loss = 1.5 - alpha, full = l1 ? 2 - alpha : 2;
  const double grading = restored ? 1.1 * full / loss : 1;  // a tenth above the limit, where a logarithm stands
  Convergence c{.statement = {std::string(l1 ? "L1" : "trapezoid derivative") + (restored ? ", graded" : ", uniform"),
                              "t^1.5, all nodes", alpha, restored ? full : loss, 0.1}};
  for (std::size_t n = 16; n <= 1024; n *= 2) {
    const std::vector<double> times = graded_mesh(1, n, grading);
    std::vector<double> x;
    x.reserve(times.size());
    for (const double t : times) x.push_back(l1 ? std::pow(t, 1.5) : 1.5 * std::sqrt(t));
    double worst = 0;
    for (std::size_t m = 1; m <= n; ++m) {
      const std::span<const double> t(times.data(), m + 1), s(x.data(), m + 1);
      const double value = l1 ? l1_derivative(alpha, t, s) : trapezoid_derivative(alpha, t, s);
      const double exact = std::tgamma(2.5) / std::tgamma(2.5 - alpha) * std::pow(times[m], 1.5 - alpha);
      worst = std::max(worst, std::fabs(value - exact));
    }
    c.steps.push_back(n);
    c.values.push_back(worst);
    c.errors.push_back(worst);
  }
  return c;
}

/// Collocation of the contact's own motion up to t = 1: D^α ζ there.
Convergence collocated(double alpha) {
  Convergence c{.statement = {"collocation", "contact", alpha, std::nullopt, 0.1}};
  c.steps = {24};
  const double error = collocate_motion(alpha, 24, 1).force(1) - mittag_leffler(2 - alpha, 2 - alpha, -1);
  c.values = {error, error};
  c.errors = {std::fabs(error)};
  return c;
}

class Orders : public Study {
 public:
  std::string name() const override { return "orders"; }
  std::string claim() const override {
    return "(59) and (60) are called accurate to the fourth power of the number of steps (garbled in print): every "
           "operator and solver against its derived order, from both sides";
  }
  StudyResult run(const RunOptions& options) override {
    std::vector<Convergence> all;
    for (const Operator& op : fractional_operators())
      for (const double alpha : studied_orders)
        for (Convergence& c : measure(op, alpha)) all.push_back(std::move(c));
    for (const double alpha : studied_orders) {
      all.push_back(collocated(alpha));
      if (!options.thorough) continue;
      for (const bool l1 : {true, false})
        for (const bool restored : {false, true}) all.push_back(graded(l1, alpha, restored));
    }
    for (const FractionalScheme scheme : stepping_schemes)
      for (const double alpha : studied_orders)
        all.push_back(measure(scheme, alpha, options.thorough ? 4096 : 2048).en);

    StudyResult result;
    result.tables.push_back(to_table(all, "Observed order of convergence of every operator and solver"));
    result.rows = to_rows(all);
    result.gates = to_gates(all);
    add_kernel_counts(result, options.thorough);
    double paper = 0;
    for (const Convergence& c : all)
      if (c.statement.scheme == "(59) derivative" && c.statement.order) paper = std::max(paper, c.observed());
    result.extra["highest_observed_order_of_59"] = paper;
    result.remarks = {
        {"Eqs. (59) and (60), order",
         "Called accurate to the fourth power of the number of steps, with an exponent that may be garbled. As written "
         "(59) reaches at most order " +
             console::fixed(paper, 2) +
             " in this run: f^(n) is held constant over each step at its left value, a rectangle rule."}};
    const auto off = std::count_if(all.begin(), all.end(), [](const Convergence& c) { return !c.pass(); });
    result.verdict = std::to_string(all.size() - static_cast<std::size_t>(off)) + " of " + std::to_string(all.size()) +
                     " measurements confirm the derived order; (59) reaches at most " + console::fixed(paper, 2) +
                     ", the order of a rectangle rule.";
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> orders_study() { return std::make_unique<Orders>(); }

}  // namespace ricochet::verify
