#include "../convergence.hpp"
#include "../convergence_figures.hpp"
#include "../convergence_tables.hpp"
#include "../selection.hpp"
#include "../solvers.hpp"
#include "kernel_table.hpp"
#include "solids.hpp"

#include <verify/registry.hpp>

#include <ricochet/fractional/collocation.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

namespace {

constexpr const char* graded_function = "t^1.5, all nodes";

std::string graded_name(bool l1, bool restored) {
  return fmt::format("{}, {}", l1 ? "L1" : "trapezoid derivative", restored ? "graded" : "uniform");
}

/// Largest error over all nodes for f = t^{3/2} on graded meshes: uniform ones lose the start, graded ones don't.
/// grading 0 stands for the one that restores the rule's order.
Convergence graded(bool l1, double alpha, bool restored, const std::vector<std::size_t>& steps) {
  const double loss = 1.5 - alpha, full = l1 ? 2 - alpha : 2;
  const double grading = restored ? 1.1 * full / loss : 1;  // a tenth above the limit, where a logarithm stands
  Convergence c{.statement = {graded_name(l1, restored), graded_function, alpha, restored ? full : loss, 0.1},
                .length = 0};
  for (const std::size_t n : steps) {
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
  Convergence c{.statement = {"collocation", "contact", alpha, std::nullopt, 0.1}, .length = 0};
  c.steps = {24};
  const double error = collocate_motion(alpha, 24, 1).force(1) - mittag_leffler(2 - alpha, 2 - alpha, -1);
  c.values = {error, error};
  c.errors = {std::fabs(error)};
  return c;
}

/// Everything that is asked for, in the order of the table.
std::vector<Convergence> measure_all(const Selection& wanted, bool thorough) {
  std::vector<Convergence> all;
  const auto add = [&](Convergence c) {
    if (wanted.function(c.statement.function)) all.push_back(std::move(c));
  };
  for (const Operator& op : fractional_operators())
    for (const double alpha : wanted.alphas())
      if (wanted.scheme(op.name))
        for (Convergence& c : measure(op, alpha, wanted.steps(4096))) add(std::move(c));
  for (const double alpha : wanted.alphas()) {
    if (wanted.scheme("collocation")) add(collocated(alpha));
    if (!thorough) continue;
    for (const bool l1 : {true, false})
      for (const bool restored : {false, true})
        if (wanted.scheme(graded_name(l1, restored))) add(graded(l1, alpha, restored, wanted.steps(1024)));
  }
  for (const FractionalScheme scheme : stepping_schemes)
    for (const double alpha : wanted.alphas())
      if (wanted.scheme(std::string(name(scheme))) && wanted.function("e_n"))
        add(measure(scheme, alpha, wanted.steps(thorough ? 4096 : 2048), stated_against(scheme)).en);
  for (Convergence& c : measure_solids(wanted)) add(std::move(c));
  return all;
}

std::vector<std::string> scheme_names(bool thorough) {
  std::vector<std::string> names;
  for (const Operator& op : fractional_operators()) names.push_back(op.name);
  names.push_back("collocation");
  for (const bool l1 : {true, false})
    for (const bool restored : {false, true})
      if (thorough) names.push_back(graded_name(l1, restored));
  for (const FractionalScheme scheme : stepping_schemes) names.emplace_back(name(scheme));
  for (const std::string& scheme : solid_schemes()) names.push_back(scheme);
  return names;
}

class Orders : public Study {
 public:
  std::string name() const override { return "orders"; }
  std::string title() const override { return "The order of every operator and solver"; }
  std::string claim() const override {
    return "(59) and (60) are called accurate to the fourth power of the number of steps (garbled in print): every "
           "operator and solver against its derived order, from both sides";
  }
  void add_options(CLI::App& app) override { wanted_.add_options(app); }
  StudyResult run(const RunOptions& options) override {
    wanted_.check(scheme_names(options.thorough), {"t", "t^2", "t^3", "sin t", "contact", graded_function, "e_n",
                                                   "e_n less near orders", "t_col, e_n"});
    const std::vector<Convergence> all = measure_all(wanted_, options.thorough);
    StudyResult result = convergence_result(all, wanted_, "orders");
    if (wanted_.everything()) add_kernel_counts(result, options.thorough);
    const double paper = highest_of_59(all);
    if (paper > 0) {
      result.extra["highest_observed_order_of_59"] = paper;
      result.remarks = {remark(paper)};
      result.verdict += fmt::format("; (59) reaches at most {:.2f}, the order of a rectangle rule", paper);
    }
    result.verdict += ".";
    return result;
  }

 private:
  static double highest_of_59(const std::vector<Convergence>& all) {
    double highest = 0;
    for (const Convergence& c : all)
      if (c.statement.scheme == "(59) derivative" && c.statement.order) highest = std::max(highest, c.observed());
    return highest;
  }

  static Remark remark(double paper) {
    return {
        "Eqs. (59) and (60), order",
        fmt::format("Called accurate to the fourth power of the number of steps, with an exponent that may be "
                    "garbled. As written (59) reaches at most order {:.2f} in this run: f^(n) is held constant over "
                    "each step at its left value, a rectangle rule.",
                    paper)};
  }

  Selection wanted_;
};

}  // namespace

std::unique_ptr<Study> orders_study() { return std::make_unique<Orders>(); }

}  // namespace ricochet::verify
