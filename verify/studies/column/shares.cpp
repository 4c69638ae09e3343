#include "shares.hpp"

#include <console/number.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ricochet::verify::column {

using console::Json;
using console::Notation;
using console::Table;

const ShareCurve& Shares::curve(const std::string& id) const {
  return *std::find_if(curves.begin(), curves.end(), [&](const ShareCurve& c) { return c.id == id; });
}

double Shares::at(const std::string& id, std::size_t n) const {
  const auto where = std::find(beads.begin(), beads.end(), n);
  return *curve(id).share[static_cast<std::size_t>(where - beads.begin())];
}

Shares measure(const std::vector<std::size_t>& beads, const ConversionFit& fit, const ColumnCase& c) {
  Shares shares{beads, {{"event-driven", {}}}};
  console::Progress progress("column", beads.size() * (column_laws().size() + 1));
  for (const std::size_t n : beads) shares.curves[0].share.push_back(event_driven_share(n, c));
  const auto add = [&](const std::string& id, auto run) {
    ShareCurve curve{id, {}};
    for (const std::size_t n : beads) {
      curve.share.push_back(run(n));
      progress.advance();
    }
    shares.curves.push_back(std::move(curve));
  };
  using Share = std::optional<double>;
  for (const ColumnLaw& law : column_laws())
    add(law.id, [&](std::size_t n) -> Share { return share(run_case(law, n, c)); });
  add("fractional alpha=0.0258",
      [&](std::size_t n) -> Share { return share(run_fractional(paper::column.alpha, n, c)); });
  // Beyond what was fitted α(nc) would leave the range of the closed forms.
  add("fractional alpha(nc)", [&](std::size_t n) -> Share {
    if (n > fit.points.back().beads) return std::nullopt;
    return share(run_fractional(fit.law(n), n, c));
  });
  return shares;
}

std::vector<ShareCurve> over_gaps(std::size_t beads, const std::vector<double>& gaps, ColumnCase c) {
  std::vector<ShareCurve> curves{{"event-driven", {}}};
  for (std::size_t i = 0; i < gaps.size(); ++i) curves[0].share.push_back(event_driven_share(beads, c));
  for (const ColumnLaw& law : column_laws()) {
    ShareCurve curve{law.id, {}};
    for (const double gap : gaps) {
      c.gap = gap;
      curve.share.push_back(share(run_case(law, beads, c)));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Table share_table(const std::string& first, const std::string& unit, const std::vector<double>& x,
                  const std::vector<ShareCurve>& curves, const std::string& caption) {
  std::vector<console::Column> columns{{first, unit}};
  for (const ShareCurve& curve : curves) columns.push_back({curve.id, "", {Notation::Kind::fixed, 4}});
  Table table(columns, caption);
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<console::Cell> cells{x[i]};
    for (const ShareCurve& curve : curves)
      cells.push_back(curve.share[i] ? console::Cell(*curve.share[i]) : console::blank());
    table.row(cells);
  }
  return table;
}

Table fit_table(const ConversionFit& fit) {
  Table table({{"nc"},
               {"event-driven", "", {Notation::Kind::fixed, 4}},
               {"alpha exact", "", {Notation::Kind::fixed, 5}},
               {"s exact", "", {Notation::Kind::fixed, 4}},
               {"alpha(nc)", "", {Notation::Kind::fixed, 5}},
               {"s(nc)", "", {Notation::Kind::fixed, 4}},
               {"share", "", {Notation::Kind::fixed, 4}},
               {"error", "", {Notation::Kind::scientific, 1}}},
              "alpha(nc) = 1 - (1 - alpha_1)^s, s = (1 + a (nc - 1))^b, fitted by NLopt to the event-driven shares");
  for (const ConversionPoint& p : fit.points)
    table.row({static_cast<std::int64_t>(p.beads), p.target, p.exact_alpha, p.exact_exponent, fit.law(p.beads),
               fit.law.exponent(p.beads), p.fitted_share, p.fitted_share - p.target});
  table.note(fmt::format("alpha_1 = {}, a = {}, b = {}; greatest error {:.1e}, rms {:.1e}; with s = nc instead {:.1e}",
                         console::significant(fit.law.first, 7), console::significant(fit.law.a, 5),
                         console::significant(fit.law.b, 5), fit.worst, fit.rms, fit.simple_worst));
  table.note("exact: the alpha whose column loses exactly the event-driven share.");
  return table;
}

Json rows(const Shares& shares, const ColumnCase& c) {
  Json all = Json::array();
  for (const ShareCurve& curve : shares.curves)
    for (std::size_t i = 0; i < shares.beads.size(); ++i) {
      const auto& value = curve.share[i];
      all.push_back({{"nc", shares.beads[i]},
                     {"gap", c.gap},
                     {"law", curve.id},
                     {"en", c.en},
                     {"tcol", c.tcol},
                     {"share", value ? Json(*value) : Json()},
                     {"energy_ratio", value ? Json(1 - *value) : Json()}});
    }
  return all;
}

}  // namespace ricochet::verify::column
