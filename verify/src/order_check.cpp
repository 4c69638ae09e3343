#include "order_file.hpp"

#include <verify/order_check.hpp>

#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/program.hpp>
#include <ricochet/verify/order.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace ricochet::verify {

namespace {

using console::Json;
using console::Notation;
using console::Table;

enum class Reference { exact, finest, richardson };

struct Judged {
  OrderCase what;
  ObservedOrder observed;

  std::string label() const {
    if (what.scheme.empty()) return what.name;
    return what.name.empty() ? what.scheme : fmt::format("{}, {}", what.scheme, what.name);
  }
};

Table summary(const std::vector<Judged>& all) {
  const Notation three{Notation::Kind::fixed, 3}, significant{Notation::Kind::significant, 4};
  Table table({{"scheme"},
               {"case"},
               {"order", "", three},
               {"+-", "", {Notation::Kind::scientific, 1}},
               {"from h", "", significant},
               {"to h", "", significant},
               {"floor", "", {Notation::Kind::scientific, 1}},
               {"verdict"}},
              "Observed order of convergence");
  for (const Judged& j : all) {
    const ObservedOrder& o = j.observed;
    const bool fitted = std::isfinite(o.order);
    table.row({j.what.scheme, j.what.name, console::number_or_blank(o.order), console::number_or_blank(o.uncertainty),
               fitted ? console::Cell(o.h[o.first]) : console::blank(),
               fitted ? console::Cell(o.h[o.last - 1]) : console::blank(),
               o.floor > 0 ? console::Cell(o.floor) : console::blank(), o.said.substr(0, o.said.find_first_of(":,"))});
  }
  for (const Judged& j : all)
    table.note(j.label().empty() ? j.observed.said : fmt::format("{}: {}", j.label(), j.observed.said));
  return table;
}

/// One row a mesh; in the fit: whether the mesh is in the range that was fitted.
Table meshes(const std::vector<Judged>& all) {
  Table table({{"scheme"}, {"case"}, {"h"}, {"error"}, {"pairwise_order"}, {"in_range"}}, "Meshes");
  for (const Judged& j : all)
    for (std::size_t i = 0; i < j.observed.h.size(); ++i) {
      const ObservedOrder& o = j.observed;
      table.row({j.what.scheme, j.what.name, o.h[i], o.error[i], console::number_or_blank(o.pairwise[i]),
                 std::isfinite(o.order) && i >= o.first && i < o.last});
    }
  return table;
}

Json rows(const std::vector<Judged>& all) {
  Json json = Json::array();
  for (const Judged& j : all)
    for (std::size_t i = 0; i < j.observed.h.size(); ++i)
      json.push_back({{"scheme", j.what.scheme},
                      {"case", j.what.name},
                      {"h", j.observed.h[i]},
                      {"error", j.observed.error[i]},
                      {"pairwise_order", console::number_or_null(j.observed.pairwise[i])}});
  return json;
}

Json fits(const std::vector<Judged>& all) {
  Json json = Json::array();
  for (const Judged& j : all) {
    const ObservedOrder& o = j.observed;
    const bool fitted = std::isfinite(o.order);
    json.push_back({{"scheme", j.what.scheme},
                    {"case", j.what.name},
                    {"order", console::number_or_null(o.order)},
                    {"uncertainty", console::number_or_null(o.uncertainty)},
                    {"range", fitted ? Json{o.h[o.first], o.h[o.last - 1]} : Json(nullptr)},
                    {"floor", o.floor > 0 ? Json(o.floor) : Json(nullptr)},
                    {"verdict", o.said}});
  }
  return json;
}

class OrderCheck : public Study {
 public:
  std::string name() const override { return "order"; }
  std::string claim() const override {
    return "Errors or values of a file, on three meshes or more a case, show the stated order of convergence, from "
           "both "
           "sides";
  }
  std::vector<console::NamedFile> inputs() const override { return {{"FILE", file_}}; }
  void add_options(CLI::App& app) override {
    app.add_option("FILE", file_, "CSV: columns h or n, error or value; optional: scheme, case. -: standard input")
        ->required();
    console::add_number(app, "--stated", claim_.stated, "the order that is stated, > 0")->required();
    console::add_number(app, "--allowed", claim_.allowed, "greatest |observed - stated|, > 0 (default 0.1)");
    console::add_number(app, "--rounding", claim_.rounding,
                        "greatest error that rounding may make, >= 0 (default 1e-10)");
    app.add_option_function<std::string>(
           "--reference", [this](const std::string& word) { set_reference(word); },
           "what errors are taken against: exact (the file has errors), finest mesh or richardson extrapolation of the "
           "two finest (the file has values)")
        ->type_name("exact|finest|richardson");
  }

  StudyResult run(const RunOptions&) override {
    check_claim();
    const OrderFile file = read_order_file(file_);
    check_reference(file);
    std::vector<Judged> all;
    for (const OrderCase& one : file.cases) all.push_back(judged(one));
    StudyResult result;
    result.tables = {summary(all), meshes(all)};
    result.data = result.tables[1];
    result.rows = rows(all);
    result.extra = {{"stated_order", claim_.stated}, {"allowed", claim_.allowed}, {"fits", fits(all)}};
    std::size_t confirmed = 0;
    for (const Judged& j : all) {
      result.gates.push_back(gate(j));
      confirmed += result.gates.back().pass;
    }
    result.verdict = fmt::format("{} of {} cases show order {}.", confirmed, all.size(), claim_.stated);
    return result;
  }

 private:
  void set_reference(const std::string& word) {
    reference_word_ = word;
    if (word == "exact")
      reference_ = Reference::exact;
    else if (word == "finest")
      reference_ = Reference::finest;
    else if (word == "richardson")
      reference_ = Reference::richardson;
    else
      throw CLI::ValidationError(fmt::format("--reference = {}: must be exact, finest or richardson", word));
  }

  void check_claim() const {
    const auto reject = [](const char* flag, double value, const char* accepted) {
      throw console::BadInput(flag, console::shortest(value), accepted);
    };
    if (!(claim_.stated > 0)) reject("--stated", claim_.stated, "> 0");
    if (!(claim_.allowed > 0)) reject("--allowed", claim_.allowed, "> 0");
    if (!(claim_.rounding >= 0)) reject("--rounding", claim_.rounding, ">= 0");
  }

  void check_reference(const OrderFile& file) {
    if (!reference_) reference_ = file.errors ? Reference::exact : Reference::richardson;
    if (file.errors != (*reference_ == Reference::exact))
      throw console::BadInput("--reference", reference_word_,
                              file.errors ? "exact: the file has a column error"
                                          : "finest or richardson: the file has a "
                                            "column value");
  }

  Judged judged(const OrderCase& one) const {
    try {
      switch (*reference_) {
        case Reference::exact: return {one, observe_order(one.h, one.value, claim_)};
        case Reference::finest: return {one, observe_order_by_finest(one.h, one.value, claim_)};
        case Reference::richardson: break;
      }
      return {one, observe_order_by_richardson(one.h, one.value, claim_)};
    } catch (const std::invalid_argument& error) {
      const Judged named{one, {}};
      const std::string label = named.label();
      const std::string text = error.what();
      const auto colon = text.find(": must be ");
      const auto equals = text.find(" = ");
      if (colon == std::string::npos || equals == std::string::npos) throw;
      throw console::BadInput(
          fmt::format("{}{}{}: {}", file_, label.empty() ? "" : ": ", label, text.substr(0, equals)),
          text.substr(equals + 3, colon - equals - 3), text.substr(colon + 10));
    }
  }

  /// An order that is inside but not settled fails as one that is outside does.
  Gate gate(const Judged& j) const {
    const std::string name = j.label().empty() ? "order" : fmt::format("{}: order", j.label());
    Gate gate = near(name, j.observed.order, claim_.stated, claim_.allowed);
    if (gate.pass && !j.observed) {
      gate.name = fmt::format("{}: uncertainty of the order", j.label().empty() ? "data" : j.label());
      return at_most(gate.name, j.observed.uncertainty, claim_.allowed);
    }
    return gate;
  }

  std::string file_;
  OrderClaim claim_;
  std::optional<Reference> reference_;
  std::string reference_word_;
};

}  // namespace

std::unique_ptr<Study> order_check() { return std::make_unique<OrderCheck>(); }

}  // namespace ricochet::verify
