#include "curves.hpp"
#include "pade.hpp"

#include <verify/registry.hpp>

#include <console/csv.hpp>
#include <console/number.hpp>
#include <ricochet/collision/reduction.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::verify {

namespace peers {

namespace {

using console::Column;
using console::Json;
using console::Notation;
using console::Table;

constexpr double shown_restitutions[] = {0.05, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};

const char* word(PeerLaw law) { return law == PeerLaw::linear ? "linear" : "tsuji"; }
const char* word(ContactEnd end) { return end == ContactEnd::force ? "force" : "overlap"; }

Table overview(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  std::vector<Column> columns{{"peer"}, {"law"}, {"end"}};
  for (const double en : shown_restitutions)
    columns.push_back({fmt::format("asked {}", en), "", {Notation::Kind::fixed, 4}});
  columns.push_back({"worst error", "", {Notation::Kind::scientific, 1}});
  columns.push_back({"at", "", {Notation::Kind::fixed, 2}});
  Table table(columns, "Restitution obtained from the damping that each engine makes of the restitution asked");
  for (const Curve& curve : curves) {
    std::vector<console::Cell> cells{std::string(curve.peer.id), word(curve.peer.law), word(curve.peer.end)};
    for (const double en : shown_restitutions)
      cells.push_back(curve.obtained[std::size_t(std::find(asked.begin(), asked.end(), en) - asked.begin())]);
    cells.push_back(curve.worst);
    cells.push_back(curve.worst_at);
    table.row(cells);
  }
  table.note("end: force where the engine clips the attractive part of the force, overlap where it does not.");
  return table;
}

Table sources(const std::vector<Curve>& curves) {
  Table table({{"peer"}, {"engine and setting"}, {"read in"}}, "Where the formulas were read");
  for (const Curve& curve : curves)
    table.row({std::string(curve.peer.id), std::string(curve.peer.engine), std::string(curve.peer.source)});
  return table;
}

/// Collision time of those that take it as input: k and c of linear1, run as the engine runs them.
Table collision_times() {
  Table table({{"asked en", "", {Notation::Kind::fixed, 2}},
               {"mercurydpm linear", "", {Notation::Kind::fixed, 6}},
               {"yade tc-en", "", {Notation::Kind::fixed, 6}}},
              "Collision time obtained over asked, where the engine takes it as input");
  constexpr double tcol = paper::pair.tcol;
  for (const double en : shown_restitutions) {
    const AnyLaw law = at_impact(unit_law(kind_of<Linear>, en, ContactEnd::overlap).value().law, tcol, impact).value();
    const auto ratio = [&](ContactEnd end) {
      return collide(law, impact, {.end = end, .method = CollideMethod::numerical}).tcol / tcol;
    };
    table.row({en, ratio(ContactEnd::overlap), ratio(ContactEnd::force)});
  }
  return table;
}

Json rows(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  Json all = Json::array();
  for (const Curve& curve : curves)
    for (std::size_t i = 0; i < asked.size(); ++i)
      all.push_back({{"peer", curve.peer.id},
                     {"law", word(curve.peer.law)},
                     {"end", word(curve.peer.end)},
                     {"en_asked", asked[i]},
                     {"en_obtained", curve.obtained[i]},
                     {"error", curve.obtained[i] - asked[i]}});
  return all;
}

class Peers : public Study {
 public:
  std::string name() const override { return "peers"; }
  std::string title() const override { return "How engines turn a restitution into damping"; }
  std::string claim() const override {
    return "Engines turn a restitution into damping by closed forms and polynomials: what comes out is what was asked "
           "only where the form was made for the end of contact that the engine uses";
  }
  StudyResult run(const RunOptions&) override;
};

/// Does the peer use −ln e/√(π² + ln² e), the form that is exact for the end by overlap?
bool logarithmic(const PeerDamping& peer) {
  return peer.damping_ratio(0.5) == damping_of_restitution(0.5, ContactEnd::overlap);
}

double least_rise(const Curve& curve, const std::vector<double>& asked) {
  double least = 1;
  for (std::size_t i = 0; i < asked.size(); ++i) least = std::min(least, curve.obtained[i] - asked[i]);
  return least;
}

/// Peers that run one formula with one law and one end: their curves are the same curve.
struct SameFormula {
  const Curve* curve;
  std::string ids;
};

std::vector<SameFormula> formulas(const std::vector<Curve>& curves) {
  std::vector<SameFormula> all;
  for (const Curve& curve : curves) {
    const PeerDamping& peer = curve.peer;
    const auto same = std::find_if(all.begin(), all.end(), [&](const SameFormula& f) {
      const PeerDamping& other = f.curve->peer;
      return other.damping_ratio == peer.damping_ratio && other.law == peer.law && other.end == peer.end;
    });
    if (same == all.end())
      all.push_back({&curve, std::string(peer.id)});
    else
      same->ids += fmt::format("; {}", peer.id);
  }
  return all;
}

/// What an engine gave, `verify engines` says how: the restitution in the limit of small steps, to 1e-3 as there.
std::vector<Gate> measured_gates(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  constexpr std::array columns{console::CsvColumn{"peer", "", true}, console::CsvColumn{"engine", "", true},
                               console::CsvColumn{"en_asked", "", true}, console::CsvColumn{"en_obtained", "", true}};
  console::CsvReader file(data_folder() + "/engine_restitutions.csv", columns);
  std::vector<Gate> all;
  while (file.next()) {
    const auto at = std::find(asked.begin(), asked.end(), file.number(2));
    const Curve& curve = find(curves, file.text(0));
    const double ours = curve.obtained.at(static_cast<std::size_t>(at - asked.begin()));
    all.push_back(near(fmt::format("{}, asked {}: en against what {} gave", file.text(0), file.number(2), file.text(1)),
                       ours, file.number(3), 1e-3 * file.number(3)));
  }
  return all;
}

std::vector<Gate> gates(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  std::vector<Gate> all;
  double closed_form = 0;
  for (const Curve& curve : curves) closed_form = std::max(closed_form, curve.closed_form);
  all.push_back(at_most("closed forms against the integrated contact, all peers, relative", closed_form, 1e-10));
  for (const auto& [curve, ids] : formulas(curves))
    if (curve->peer.exact)
      all.push_back(at_most(fmt::format("exact, worst relative error: {}", ids), curve->worst_relative, 1e-10));
  // What a clipped force does is known in sign: the attraction that would have slowed the rebound is missing.
  for (const auto& [curve, ids] : formulas(curves))
    if (curve->peer.end == ContactEnd::force && logarithmic(curve->peer))
      all.push_back(
          at_least(fmt::format("clipping raises the restitution, least rise: {}", ids), least_rise(*curve, asked), 0));
  all.push_back(holds("Marshall's fit belongs to the particle's mass, not to the pair's effective mass",
                      find(curves, "lammps tsuji 2026").worst < find(curves, "lammps tsuji 2021").worst));
  for (const Gate& gate : measured_gates(curves, asked)) all.push_back(gate);
  return all;
}

StudyResult Peers::run(const RunOptions&) {
  const std::vector<double> asked = asked_restitutions();
  std::vector<Curve> curves;
  for (const PeerDamping& peer : peer_dampings()) curves.push_back(measure(peer, asked));
  const Curve& lammps = find(curves, "lammps tsuji 2021");
  const Curve& clipped = find(curves, "liggghts hertz, limited");
  const std::size_t half = std::size_t(std::find(asked.begin(), asked.end(), 0.5) - asked.begin());
  StudyResult result;
  result.gates = gates(curves, asked);
  result.tables = {overview(curves, asked), collision_times(), pade_table(), sources(curves)};
  result.rows = rows(curves, asked);
  for (const Gate& gate : pade_gates()) result.gates.push_back(gate);
  for (const Json& row : pade_rows()) result.rows.push_back(row);
  result.figures = {error_figure(curves, asked)};
  result.figures[0].finding = fmt::format(
      "Only the logarithmic form with the contact ended by overlap gives what was asked; with a clipped force it gives "
      "{:.3f} too much at 0.5, LAMMPS tsuji of 2021 {:.3f}.",
      clipped.obtained[half] - 0.5, lammps.obtained[half] - 0.5);
  result.verdict = fmt::format(
      "Asked for 0.5, LAMMPS of 2021 with damping tsuji gives {:.4f} and every logarithmic form with a clipped force "
      "{:.4f}.",
      lammps.obtained[half], clipped.obtained[half]);
  return result;
}

}  // namespace

}  // namespace peers

std::unique_ptr<Study> peers_study() { return std::make_unique<peers::Peers>(); }

}  // namespace ricochet::verify
