#include "convergence.hpp"

#include <ricochet/verify/order.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

using console::Json;

double Convergence::observed() const {
  std::size_t n = errors.size();
  while (n > 4 && errors[n - 1] < rounding * scale) --n;
  if (n < 2) return std::nan("");
  const std::size_t coarse = n < 4 ? 0 : n - 4;
  const double refinement = static_cast<double>(steps[n - 1]) / static_cast<double>(steps[coarse]);
  return std::log2(errors[coarse] / errors[n - 1]) / std::log2(refinement);
}

double Convergence::pairwise(std::size_t i) const {
  if (i == 0) return std::nan("");
  return pairwise_order(1 / static_cast<double>(steps[i - 1]), errors[i - 1], 1 / static_cast<double>(steps[i]),
                        errors[i]);
}

namespace {

/// (N_fine/N_coarse)^p of the last two meshes.
double gain(const Convergence& c) {
  const std::size_t n = c.steps.size();
  return std::pow(static_cast<double>(c.steps[n - 1]) / static_cast<double>(c.steps[n - 2]),
                  c.statement.order.value_or(1));
}

}  // namespace

double Convergence::richardson_error() const {
  const std::size_t n = values.size();
  if (n < 2 || steps.size() < 2) return std::nan("");
  const double factor = gain(*this);
  return (factor * values[n - 1] - values[n - 2]) / (factor - 1);
}

double Convergence::grid_convergence_index() const {
  const std::size_t n = values.size();
  if (n < 2 || steps.size() < 2) return std::nan("");
  return 1.25 * std::fabs(values[n - 1] - values[n - 2]) / (gain(*this) - 1) / scale;
}

bool Convergence::pass() const {
  if (!statement.order)
    return std::all_of(errors.begin(), errors.end(), [this](double e) { return e <= exact_bound * scale; });
  return std::fabs(observed() - *statement.order) <= statement.allowed;
}

Json to_rows(const std::vector<Convergence>& all) {
  Json rows = Json::array();
  for (const Convergence& c : all) {
    Json row{{"scheme", c.statement.scheme}, {"function", c.statement.function}, {"alpha", c.statement.alpha}};
    row["stated_order"] = c.statement.order ? Json(*c.statement.order) : Json(nullptr);
    row["observed_order"] = c.statement.order ? console::number_or_null(c.observed()) : Json(nullptr);
    row["allowed"] = c.statement.allowed;
    row["steps"] = c.steps;
    row["errors"] = c.errors;
    if (!c.worst.empty()) row["worst_errors"] = c.worst;
    row["richardson_error"] = console::number_or_null(c.richardson_error());
    row["gci"] = console::number_or_null(c.grid_convergence_index());
    row["pass"] = c.pass();
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::size_t> doubled_steps(std::size_t finest) {
  std::vector<std::size_t> steps;
  for (std::size_t n = 16; n <= finest; n *= 2) steps.push_back(n);
  return steps;
}

std::vector<Gate> to_gates(const std::vector<Convergence>& all) {
  struct Worst {
    std::string scheme;
    double deviation = -1, exact = -1;
  };
  std::vector<Worst> schemes;
  for (const Convergence& c : all) {
    auto found = std::find_if(schemes.begin(), schemes.end(), [&](auto& w) { return w.scheme == c.statement.scheme; });
    if (found == schemes.end()) found = schemes.insert(found, {c.statement.scheme});
    // std::max would swallow a NaN that stands second: keep what fails.
    const auto keep = [](double& kept, double value) {
      if (!std::isnan(kept) && !(value <= kept)) kept = value;
    };
    if (c.statement.order) {
      keep(found->deviation, std::fabs(c.observed() - *c.statement.order) / c.statement.allowed);
    } else {
      for (const double error : c.errors) keep(found->exact, error / c.scale);
    }
  }
  std::vector<Gate> gates;
  for (const Worst& w : schemes) {
    if (w.deviation >= 0 || std::isnan(w.deviation))
      gates.push_back(at_most(fmt::format("{}: worst |observed - stated| / allowed", w.scheme), w.deviation, 1));
    if (w.exact >= 0 || std::isnan(w.exact))
      gates.push_back(at_most(fmt::format("{}: worst error where exact", w.scheme), w.exact, exact_bound));
  }
  return gates;
}

}  // namespace ricochet::verify
