#include "row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify::benchmarks {

namespace {

using console::Notation;
using console::Table;

constexpr int meshes = 48, levels = 3;
constexpr double rounding = 1e-10;  // of sums over some thousand steps
// What is left of higher orders at 100 steps a collision.
constexpr double order_allowance = 0.25;

struct Mean {
  double value = 0, standard_error = 0;  // the latter relative
};

Mean mean_of(const std::vector<double>& errors) {
  const auto n = static_cast<double>(errors.size());
  double sum = 0, squares = 0;
  for (const double e : errors) sum += e;
  const double mean = sum / n;
  for (const double e : errors) squares += (e - mean) * (e - mean);
  return {mean, mean > 0 ? std::sqrt(squares / (n * (n - 1))) / mean : 0};
}

double relative_error(const Asked& asked, double value) { return std::abs(value - asked.exact) / asked.scale; }

Row row_of(const Asked& asked, const std::array<std::vector<double>, levels>& errors, double ours) {
  Row row{.asked = asked, .ours = ours};
  std::array<Mean, levels> means{};
  for (std::size_t level = 0; level < levels; ++level)
    means[level] = mean_of(errors[level]), row.errors[level] = means[level].value;
  row.noise = 3 * std::hypot(means[0].standard_error, means[2].standard_error) / std::log(4.0);
  return row;
}

}  // namespace

double Row::order() const { return 0.5 * std::log2(errors[0] / errors[2]); }

std::vector<Row> measure(const std::vector<Asked>& asked, double tcol, const Measurement& values) {
  std::vector<std::array<std::vector<double>, levels>> errors(asked.size());
  std::vector<double> finest;
  for (std::size_t level = 0; level < levels; ++level)
    for (int mesh = 0; mesh < meshes; ++mesh) {
      const double finer = 1 + 0.5 * mesh / meshes, step = tcol / ((coarsest << level) * finer);
      finest = values(step);
      for (std::size_t q = 0; q < asked.size(); ++q) {
        const double order = asked[q].check == Check::rounding ? 0 : asked[q].order.second;
        errors[q][level].push_back(relative_error(asked[q], finest[q]) * std::pow(finer, order));
      }
    }
  std::vector<Row> rows;
  rows.reserve(asked.size());
  for (std::size_t q = 0; q < asked.size(); ++q) rows.push_back(row_of(asked[q], errors[q], finest[q]));
  return rows;
}

void add_gates(std::vector<Gate>& gates, const std::vector<Row>& rows) {
  constexpr double finest_steps = coarsest << (levels - 1);
  const double second_order = std::pow(std::numbers::pi / finest_steps, 2);
  for (const Row& row : rows) {
    const Asked& asked = row.asked;
    const std::string what = fmt::format("{}: {}", asked.test, asked.quantity);
    const double bound = std::pow(std::numbers::pi / finest_steps, asked.order.first);
    if (asked.check == Check::order)
      gates.push_back(between(what + ", observed order", row.order(), asked.order.first - order_allowance - row.noise,
                              asked.order.second + order_allowance + row.noise));
    const double worst = *std::max_element(row.errors.begin(), row.errors.end());
    gates.push_back(asked.check != Check::rounding
                        ? at_most(what + ", relative error", row.errors.back(), bound)
                        : at_most(what + ", relative error, rounding only", worst, rounding));
    if (asked.published)
      gates.push_back(
          near(what + ", as published", row.ours, *asked.published, asked.reading + second_order * asked.scale));
  }
}

Table table(const std::vector<Row>& rows) {
  const Notation eight{Notation::Kind::significant, 8}, sci{Notation::Kind::scientific, 1};
  Table table({{"test"},
               {"quantity"},
               {"unit"},
               {"published", "", eight},
               {"exact", "", eight},
               {"ours", "", eight},
               {"error", "", sci},
               {"order", "", {Notation::Kind::fixed, 2}}},
              "Benchmarks: what is published, what is exact, and what clusters make of it");
  for (const Row& row : rows) {
    const Asked& a = row.asked;
    table.row({a.test, a.quantity, a.unit, a.published ? console::Cell(*a.published) : console::blank(), a.exact,
               row.ours, row.errors.back(),
               a.check == Check::order ? console::number_or_blank(row.order()) : console::blank()});
  }
  table.note(fmt::format("error: relative, mean over {} meshes of {} to {} steps a collision; order: from {} steps.",
                         meshes, coarsest << (levels - 1), (coarsest << (levels - 1)) * 3 / 2, coarsest));
  return table;
}

console::Json to_json(const Row& row) {
  const Asked& a = row.asked;
  console::Json j = {{"test", a.test},       {"quantity", a.quantity}, {"unit", a.unit},       {"exact", a.exact},
                     {"published", nullptr}, {"ours", row.ours},       {"errors", row.errors}, {"order", nullptr}};
  if (a.published) j["published"] = *a.published;
  if (a.check == Check::order) j["order"] = console::number_or_null(row.order());
  return j;
}

}  // namespace ricochet::verify::benchmarks
