#include "convergence_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace ricochet::verify {

using console::Align;
using console::blank;
using console::Cell;
using console::Column;
using console::Notation;
using console::number_or_blank;
using console::Table;

namespace {

constexpr Notation order_notation{Notation::Kind::fixed, 2};

std::vector<double> alphas_of(const std::vector<Convergence>& cases) {
  std::vector<double> alphas;
  for (const Convergence& c : cases)
    if (std::find(alphas.begin(), alphas.end(), c.statement.alpha) == alphas.end()) alphas.push_back(c.statement.alpha);
  return alphas;
}

std::vector<std::string> functions_of(const std::vector<Convergence>& cases) {
  std::vector<std::string> functions;
  for (const Convergence& c : cases)
    if (std::find(functions.begin(), functions.end(), c.statement.function) == functions.end())
      functions.push_back(c.statement.function);
  return functions;
}

const Convergence* find(const std::vector<Convergence>& cases, const std::string& function, double alpha) {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Convergence& c) {
    return c.statement.function == function && c.statement.alpha == alpha;
  });
  return found == cases.end() ? nullptr : &*found;
}

/// "1.10" or "1.10..1.90".
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  Cell cell() const {
    if (low > high) return blank();
    const std::string first = fmt::format("{:.2f}", low), last = fmt::format("{:.2f}", high);
    return first == last ? first : fmt::format("{}..{}", first, last);
  }
};

/// The rows of one function: every mesh, then what is stated and what was observed.
void add_function(Table& table, const std::string& function, const std::vector<const Convergence*>& cases) {
  const auto first = std::find_if(cases.begin(), cases.end(), [](const Convergence* c) { return c != nullptr; });
  for (std::size_t i = 0; i < (*first)->steps.size(); ++i) {
    std::vector<Cell> cells{i == 0 ? function : std::string(), std::to_string((*first)->steps[i])};
    for (const Convergence* c : cases) {
      cells.push_back(c ? number_or_blank(c->errors[i]) : blank());
      cells.push_back(c && c->statement.order ? number_or_blank(c->pairwise(i)) : Cell(std::string()));
    }
    table.row(std::move(cells));
  }
  std::vector<Cell> stated{std::string(), "stated"}, observed{std::string(), "observed"};
  for (const Convergence* c : cases) {
    if (c == nullptr) {
      stated.insert(stated.end(), 2, Cell(std::string()));
      observed.insert(observed.end(), 2, Cell(std::string()));
      continue;
    }
    const bool has_order = c->statement.order.has_value();
    stated.insert(stated.end(), {std::string(), has_order ? Cell(*c->statement.order) : Cell("exact")});
    observed.insert(observed.end(),
                    {Cell(c->pass() ? "" : "FAILS"), has_order ? number_or_blank(c->observed()) : Cell(std::string())});
  }
  table.row(std::move(stated));
  table.row(std::move(observed));
}

Table scheme_table(const std::vector<Convergence>& cases) {
  const auto alphas = alphas_of(cases);
  std::vector<Column> columns{{"function"}, {"N", "", {}, Align::right}};
  for (const double alpha : alphas) {
    columns.push_back({fmt::format("α = {}", alpha), "", {Notation::Kind::scientific, 2}, Align::right});
    columns.push_back({"order", "", order_notation, Align::right});
  }
  Table table(columns, fmt::format("{}: error and pairwise order", cases.front().statement.scheme));
  for (const std::string& function : functions_of(cases)) {
    std::vector<const Convergence*> row;
    row.reserve(alphas.size());
    for (const double alpha : alphas) row.push_back(find(cases, function, alpha));
    add_function(table, function, row);
  }
  return table;
}

}  // namespace

std::vector<std::vector<Convergence>> by_scheme(const std::vector<Convergence>& all) {
  std::vector<std::vector<Convergence>> schemes;
  for (const Convergence& c : all) {
    const auto same = [&](const std::vector<Convergence>& s) { return s[0].statement.scheme == c.statement.scheme; };
    auto found = std::find_if(schemes.begin(), schemes.end(), same);
    if (found == schemes.end()) found = schemes.insert(schemes.end(), std::vector<Convergence>());
    found->push_back(c);
  }
  return schemes;
}

Table long_table(const std::vector<Convergence>& all) {
  Table table(
      {{"scheme"}, {"function"}, {"alpha"}, {"n"}, {"dt"}, {"error"}, {"pairwise_order"}, {"stated_order"}, {"pass"}});
  for (const Convergence& c : all) {
    const bool pass = c.pass();
    for (std::size_t i = 0; i < c.steps.size(); ++i) {
      const auto n = static_cast<std::int64_t>(c.steps[i]);
      table.row({c.statement.scheme, c.statement.function, c.statement.alpha, n,
                 c.length > 0 ? Cell(c.length / static_cast<double>(n)) : blank(), number_or_blank(c.errors[i]),
                 number_or_blank(c.pairwise(i)), c.statement.order ? Cell(*c.statement.order) : blank(), pass});
    }
  }
  return table;
}

Table summary_table(const std::vector<Convergence>& all, const std::string& caption) {
  Table table({{"scheme"},
               {"cases"},
               {"pass"},
               {"stated"},
               {"observed"},
               {"worst/allowed", "", order_notation},
               {"at"},
               {"worst where exact", "", {Notation::Kind::scientific, 1}}},
              caption);
  for (const auto& cases : by_scheme(all)) {
    Range stated, observed;
    std::optional<double> worst, exact;
    std::string at;
    for (const Convergence& c : cases) {
      if (!c.statement.order) {
        for (const double e : c.errors) exact = std::max(exact.value_or(0), e / c.scale);
        continue;
      }
      stated.add(*c.statement.order), observed.add(c.observed());
      const double off = std::fabs(c.observed() - *c.statement.order) / c.statement.allowed;
      if (!worst || !(off <= *worst))
        worst = off, at = fmt::format("{}, α = {}", c.statement.function, c.statement.alpha);
    }
    const auto passed = std::count_if(cases.begin(), cases.end(), [](const Convergence& c) { return c.pass(); });
    table.row({cases[0].statement.scheme, static_cast<std::int64_t>(cases.size()), static_cast<std::int64_t>(passed),
               stated.cell(), observed.cell(), worst ? number_or_blank(*worst) : blank(), at,
               exact ? number_or_blank(*exact) : blank()});
  }
  table.note(
      "observed: mean of the last three pairs of meshes; worst/allowed: greatest |observed - stated| / allowed.");
  table.note("exact: the error is rounding, at most 1e-11.");
  return table;
}

std::vector<Table> scheme_tables(const std::vector<Convergence>& all) {
  std::vector<Table> tables;
  for (const auto& cases : by_scheme(all)) tables.push_back(scheme_table(cases));
  return tables;
}

}  // namespace ricochet::verify
