#include "convergence.hpp"

#include <console/number.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

using console::Json;
using console::Notation;
using console::Table;

double Convergence::observed() const {
  std::size_t n = errors.size();
  while (n > 4 && errors[n - 1] < rounding * scale) --n;
  return n < 4 ? std::nan("") : std::log2(errors[n - 4] / errors[n - 1]) / 3;
}

double Convergence::richardson_error() const {
  const std::size_t n = values.size();
  const double factor = std::exp2(statement.order.value_or(1));
  return (factor * values[n - 1] - values[n - 2]) / (factor - 1);
}

double Convergence::grid_convergence_index() const {
  const std::size_t n = values.size();
  return 1.25 * std::fabs(values[n - 1] - values[n - 2]) / (std::exp2(statement.order.value_or(1)) - 1) / scale;
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

Table to_table(const std::vector<Convergence>& all, const std::string& caption) {
  const Notation order{Notation::Kind::fixed, 2}, error{Notation::Kind::scientific, 1};
  bool offsets = false;
  for (const Convergence& c : all) offsets |= !c.worst.empty();
  std::vector<console::Column> columns{{"scheme"},
                                       {"function"},
                                       {"alpha", "", order},
                                       {"stated", "", order},
                                       {"observed", "", order},
                                       {"allowed", "", order},
                                       {"N"},
                                       {"coarsest error", "", error},
                                       {"finest error", "", error}};
  if (offsets) columns.push_back({"finest, worst offset", "", error});
  for (const char* name : {"Richardson error", "GCI"}) columns.push_back({name, "", error});
  columns.push_back({"pass"});
  Table table(columns, caption);
  for (const Convergence& c : all) {
    const bool exact = !c.statement.order;
    std::vector<console::Cell> cells{c.statement.scheme,
                                     c.statement.function,
                                     c.statement.alpha,
                                     exact ? console::Cell("exact") : console::Cell(*c.statement.order),
                                     exact ? console::blank() : console::number_or_blank(c.observed()),
                                     exact ? console::blank() : console::Cell(c.statement.allowed),
                                     std::to_string(c.steps.front()) + ".." + std::to_string(c.steps.back()),
                                     c.errors.front(),
                                     c.errors.back()};
    if (offsets) cells.push_back(c.worst.empty() ? console::blank() : console::Cell(c.worst.back()));
    cells.push_back(exact ? console::blank() : console::number_or_blank(c.richardson_error()));
    cells.push_back(exact ? console::blank() : console::number_or_blank(c.grid_convergence_index()));
    cells.push_back(c.pass());
    table.row(std::move(cells));
  }
  table.note("observed: mean of the last three pairs of meshes. exact: the error is rounding, at most 1e-11.");
  return table;
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
      gates.push_back(at_most(w.scheme + ": worst |observed - stated| / allowed", w.deviation, 1));
    if (w.exact >= 0 || std::isnan(w.exact))
      gates.push_back(at_most(w.scheme + ": worst error where exact", w.exact, exact_bound));
  }
  return gates;
}

}  // namespace ricochet::verify
