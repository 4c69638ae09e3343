#include <verify/registry.hpp>

#include <console/number.hpp>
#include <ricochet/collision/peer_damping.hpp>
#include <ricochet/collision/collision.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify {

namespace {

using console::Column;
using console::Json;
using console::Notation;
using console::Table;

// Any pair would do: the restitution of both laws depends on β alone. The stiffness is set so that a contact of a
// millimetre-sized grain lasts about 0.1 ms.
constexpr Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};
constexpr double linear_stiffness = 5000, hertz_stiffness = 1.4e6;

constexpr double shown_restitutions[] = {0.05, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};

/// e_n asked: 0.05, 0.06, … 0.99.
std::vector<double> asked_restitutions() {
  std::vector<double> asked;
  for (int percent = 5; percent <= 99; ++percent) asked.push_back(percent / 100.0);
  return asked;
}

/// Integrates the contact that `peer` makes of the restitution asked, without any closed form.
double obtained_restitution(const PeerDamping& peer, double asked) {
  const double beta = peer.damping_ratio(asked);
  const CollideOptions options{.end = peer.end, .method = CollideMethod::numerical};
  const double m = impact.mass_eff;
  if (peer.law == PeerLaw::linear)
    return collide(Linear(linear_stiffness, 2 * beta * std::sqrt(m * linear_stiffness)), impact, options).en;
  return collide(Tsuji(hertz_stiffness, beta * std::sqrt(5 * m * hertz_stiffness)), impact, options).en;
}

struct Curve {
  PeerDamping peer;
  std::vector<double> obtained = {};  ///< over asked_restitutions()
  double worst = 0;                   ///< greatest |obtained − asked|
  double worst_at = 0;                ///< where, e_n asked
  double worst_relative = 0;          ///< greatest |obtained/asked − 1|
  double closed_form = 0;             ///< greatest relative difference from the closed form of damping_ratio.hpp
};

Curve measure(const PeerDamping& peer, const std::vector<double>& asked) {
  Curve curve{.peer = peer};
  for (const double en : asked) {
    const double obtained = obtained_restitution(peer, en);
    curve.obtained.push_back(obtained);
    if (std::abs(obtained - en) > curve.worst) {
      curve.worst = std::abs(obtained - en);
      curve.worst_at = en;
    }
    curve.worst_relative = std::max(curve.worst_relative, std::abs(obtained / en - 1));
    const double closed = restitution_of_damping(peer.damping_ratio(en), peer.end);
    curve.closed_form = std::max(curve.closed_form, std::abs(obtained / closed - 1));
  }
  return curve;
}

const char* word(PeerLaw law) { return law == PeerLaw::linear ? "linear" : "tsuji"; }
const char* word(ContactEnd end) { return end == ContactEnd::force ? "force" : "overlap"; }

Table overview(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  std::vector<Column> columns{{"peer"}, {"law"}, {"end"}};
  for (const double en : shown_restitutions)
    columns.push_back({"asked " + console::shortest(en), "", {Notation::Kind::fixed, 4}});
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
  constexpr double tcol = 1e-4;
  const double m = impact.mass_eff;
  for (const double en : shown_restitutions) {
    const double loss = -std::log(en);
    const Linear law(m * (std::numbers::pi * std::numbers::pi + loss * loss) / (tcol * tcol), 2 * m * loss / tcol);
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

const Curve& find(const std::vector<Curve>& curves, std::string_view id) {
  return *std::find_if(curves.begin(), curves.end(), [id](const Curve& curve) { return curve.peer.id == id; });
}

console::Figure figure(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  // One curve for each formula and end that differs from the others.
  struct Drawn {
    const char* id;
    const char* title;
  };
  constexpr Drawn drawn[] = {
      {"lammps tsuji 2021", "LAMMPS tsuji, 29 Sep 2021 (pair mass)"},
      {"liggghts hertz, limited", "logarithmic form, force clipped (LIGGGHTS limitForce, Yade tc-en, ...)"},
      {"mfix hertz 21", "MFiX up to 21.3.2, Hertz (factor 2)"},
      {"lammps tsuji 2026", "LAMMPS tsuji, 2026 (particle mass)"},
      {"yade mindlin 2023", "Yade 2023, Kratos (polynomial of Thornton et al.)"},
      {"liggghts hertz", "logarithmic form, ended by overlap"}};
  std::string csv = "en_asked";
  for (const Drawn& d : drawn) csv += std::string(",\"") + d.id + '"';
  csv += "\n";
  for (std::size_t i = 0; i < asked.size(); ++i) {
    csv += console::shortest(asked[i]);
    for (const Drawn& d : drawn) csv += "," + console::shortest(find(curves, d.id).obtained[i]);
    csv += "\n";
  }
  std::string script =
      "set xlabel 'restitution asked'\nset ylabel 'restitution obtained - asked'\nset xrange [0:1]\n"
      "set yrange [-0.02:0.2]\nset key below maxcols 2\nset xzeroaxis lt 1 lc rgb 'black' lw 0.7\nplot ";
  int column = 2;
  for (const Drawn& d : drawn) {
    script += (column > 2 ? ", \\\n  " : "") + std::string("'peers-error.csv' skip 1 using 1:($") +
              std::to_string(column) + "-$1) with lines lw 2 title \"" + d.title + "\"";
    ++column;
  }
  return {.name = "peers-error",
          .caption = "Restitution obtained less restitution asked, for the formulas that engines use.",
          .script = script + "\n",
          .data = {{"peers-error.csv", csv}},
          .width = 900,
          .height = 560};
}

class Peers : public Study {
 public:
  std::string name() const override { return "peers"; }
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

std::vector<Gate> gates(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  std::vector<Gate> all;
  double closed_form = 0;
  for (const Curve& curve : curves) closed_form = std::max(closed_form, curve.closed_form);
  all.push_back(at_most("closed forms against the integrated contact, all peers, relative", closed_form, 1e-10));
  for (const Curve& curve : curves)
    if (curve.peer.exact)
      all.push_back(at_most(std::string(curve.peer.id) + ": exact, worst relative error", curve.worst_relative, 1e-10));
  // What a clipped force does is known in sign: the attraction that would have slowed the rebound is missing.
  for (const Curve& curve : curves)
    if (curve.peer.end == ContactEnd::force && logarithmic(curve.peer))
      all.push_back(at_least(std::string(curve.peer.id) + ": clipping raises the restitution, least rise",
                             least_rise(curve, asked), 0));
  all.push_back(holds("Marshall's fit belongs to the particle's mass, not to the pair's effective mass",
                      find(curves, "lammps tsuji 2026").worst < find(curves, "lammps tsuji 2021").worst));
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
  result.tables = {overview(curves, asked), collision_times(), sources(curves)};
  result.rows = rows(curves, asked);
  result.figures = {figure(curves, asked)};
  result.figures[0].finding =
      "Only the logarithmic form with the contact ended by overlap gives what was asked; with a clipped "
      "force it gives " +
      console::fixed(clipped.obtained[half] - 0.5, 3) + " too much at 0.5, LAMMPS tsuji of 2021 " +
      console::fixed(lammps.obtained[half] - 0.5, 3) + ".";
  result.verdict = "Asked for 0.5, LAMMPS of 2021 with damping tsuji gives " +
                   console::fixed(lammps.obtained[half], 4) + " and every logarithmic form with a clipped force " +
                   console::fixed(clipped.obtained[half], 4) + ".";
  return result;
}

}  // namespace

std::unique_ptr<Study> peers_study() { return std::make_unique<Peers>(); }

}  // namespace ricochet::verify
