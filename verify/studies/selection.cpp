#include "selection.hpp"

#include "convergence_figures.hpp"
#include "convergence_tables.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace ricochet::verify {

namespace {

bool holds(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

void require_known(const char* flag, const std::vector<std::string>& wanted, const std::vector<std::string>& known) {
  for (const std::string& word : wanted)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw console::BadInput(flag, word, fmt::format("one of: {}", fmt::join(known, "; ")));
}

}  // namespace

std::vector<double> numbers(const std::string& flag, const std::vector<std::string>& fields) {
  std::vector<double> values;
  for (const std::string& field : fields) {
    const auto value = console::parse_number(field);
    if (!value) throw CLI::ValidationError(fmt::format("{} = {}: must be a finite number", flag, field));
    values.push_back(*value);
  }
  return values;
}

void Selection::add_options(CLI::App& app) {
  app.add_option("--scheme", schemes_, "only this operator or solver, as the table names it; may be repeated")
      ->type_name("S")
      ->allow_extra_args(false);
  app.add_option("--function", functions_, "only this function or quantity, as the table names it; may be repeated")
      ->type_name("F")
      ->allow_extra_args(false);
  app.add_option_function<std::vector<std::string>>(
         "--alpha", [this](const std::vector<std::string>& fields) { alphas_ = numbers("--alpha", fields); },
         "these orders instead of 0.1,0.25,0.5,0.75,0.9; in [0.01, 0.97]")
      ->type_name("A,A,…")
      ->delimiter(',');
  app.add_option_function<std::vector<std::string>>(
         "--steps",
         [this](const std::vector<std::string>& fields) {
           for (const double n : numbers("--steps", fields)) {
             if (!(n >= 4 && n <= 65536) || n != static_cast<double>(static_cast<std::size_t>(n)))
               throw CLI::ValidationError(fmt::format("--steps = {}: must be whole numbers from 4 to 65536", n));
             steps_.push_back(static_cast<std::size_t>(n));
           }
         },
         "these numbers of steps, growing, at least three; the gates then judge the last pairs of these")
      ->type_name("N,N,…")
      ->delimiter(',');
  app.add_flag("--summary", summary_, "one line a scheme instead of every mesh");
}

void Selection::check(const std::vector<std::string>& schemes, const std::vector<std::string>& functions) const {
  require_known("--scheme", schemes_, schemes);
  require_known("--function", functions_, functions);
  for (const double alpha : alphas_)
    if (!(alpha >= 0.01 && alpha <= 0.97))
      throw console::BadInput("--alpha", console::shortest(alpha), "in [0.01, 0.97]");
  if (steps_.empty()) return;
  const bool grows = std::adjacent_find(steps_.begin(), steps_.end(), std::greater_equal<>()) == steps_.end();
  if (steps_.size() < 3 || !grows)
    throw console::BadInput("--steps", fmt::format("{}", fmt::join(steps_, ",")),
                            "at least three, each above the last");
}

bool Selection::scheme(const std::string& name) const { return holds(schemes_, name); }

bool Selection::function(const std::string& name) const { return holds(functions_, name); }

std::vector<double> Selection::alphas() const {
  if (!alphas_.empty()) return alphas_;
  return {std::begin(studied_orders), std::end(studied_orders)};
}

std::vector<std::size_t> Selection::steps(std::size_t finest) const {
  return steps_.empty() ? doubled_steps(finest) : steps_;
}

StudyResult convergence_result(const std::vector<Convergence>& all, const Selection& wanted,
                               const std::string& prefix) {
  if (all.empty())
    throw console::BadInput("--function", "the chosen one", "one that the chosen schemes are measured with");
  StudyResult result;
  result.gates = to_gates(all);
  result.rows = to_rows(all);
  result.data = long_table(all);
  result.tables = {summary_table(all, "Observed order of convergence, from both sides")};
  if (!wanted.summary_only())
    for (console::Table& table : scheme_tables(all)) result.tables.push_back(std::move(table));
  result.figures = convergence_figures(all, prefix);
  const auto passed = std::count_if(all.begin(), all.end(), [](const Convergence& c) { return c.pass(); });
  result.verdict = fmt::format("{} of {} measurements confirm the derived order", passed, all.size());
  return result;
}

}  // namespace ricochet::verify
