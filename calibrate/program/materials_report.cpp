#include "materials.hpp"
#include "report.hpp"

#include <console/input.hpp>
#include <console/json.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet::calibration {
namespace {

using console::Cell;
using console::Json;
using console::Notation;
using console::Table;

constexpr Notation three{Notation::Kind::significant, 3};

/// All that there is to tell of a file of materials.
struct Answer {
  Materials materials;
  std::vector<PairResult> found;
  std::vector<PairMissed> missed;
  std::vector<EngineStep> steps;
  std::vector<SizeChoice> choices = {};  ///< where there are ranges of radii and all pairs are found

  /// As engines keep the numbers; the one that runs the fractional law keeps its target.
  std::vector<SizedContact> sizes(const PairResult& pair) const {
    return over_sizes(materials, pair, materials.law == kind_of<Fractional> ? Kept::target : Kept::numbers);
  }
  const std::string& name(std::size_t kind) const { return materials.all[kind].name; }
  std::string between(const Pair& pair) const { return fmt::format("{}, {}", name(pair.a), name(pair.b)); }
};

std::vector<PairOutcome> outcomes_of(const std::string& file, const Materials& materials) {
  try {
    return calibrate_pairs(materials);
  } catch (const std::invalid_argument& misuse) {
    throw console::BadInput(fmt::format("{}: {}", file, misuse.what()));
  }
}

bool any_sizes(const Materials& materials) {
  return std::any_of(materials.all.begin(), materials.all.end(), [](const Material& m) { return !m.one_size(); });
}

Answer answer(const std::string& file, Materials materials) {
  Answer all{std::move(materials), {}, {}, {}};
  for (const PairOutcome& outcome : outcomes_of(file, all.materials)) {
    if (const auto* found = std::get_if<PairResult>(&outcome)) all.found.push_back(*found);
    if (const auto* missed = std::get_if<PairMissed>(&outcome)) all.missed.push_back(*missed);
  }
  all.steps = engine_steps(all.materials, all.found);
  if (any_sizes(all.materials) && all.missed.empty()) all.choices = size_choices(all.materials, all.found);
  return all;
}

/// The smaller radius of the two bodies.
double smaller(const SizedContact& s) { return s.radius_b > 0 ? std::min(s.radius_a, s.radius_b) : s.radius_a; }

double smaller(const Answer& all, const Pair& pair) {
  const Material &a = all.materials.all[pair.a], &b = all.materials.all[pair.b];
  const double ra = 0.5 * (a.least + a.greatest), rb = 0.5 * (b.least + b.greatest);
  return b.wall ? ra : std::min(ra, rb);
}

/// Beyond a tenth of the radius a contact is no small thing beside its grain.
void note_soft(Table& table, const Answer& all) {
  for (const PairResult& p : all.found)
    if (const double share = p.found.achieved.max_overlap / smaller(all, p.asked); share > 0.1)
      table.note(fmt::format("{}: the overlap passes 10 % of the radius; take it stiffer, or a shorter tcol",
                             all.between(p.asked)));
}

Table pair_table(const Answer& all) {
  std::vector<console::Column> columns{{"pair"}, {"en"}, {"tcol", "s", {Notation::Kind::significant, 6}}};
  for (const Parameter& p : all.materials.law.parameters())
    columns.push_back({std::string(p.name), p.unit(), {Notation::Kind::significant, 9}});
  columns.insert(columns.end(), {{"effective mass", "kg", {Notation::Kind::significant, 6}},
                                 {"max overlap/radius", "%", three},
                                 {"max force", "N", three}});
  Table table(columns, fmt::format("{} law, contacts ended by {}, at {} m/s", all.materials.law.name(),
                                   text(all.materials.end), console::shortest(all.materials.velocity)));
  for (const PairResult& p : all.found) {
    std::vector<Cell> row{all.between(p.asked), p.target.en, p.target.tcol};
    for (const double value : values(p.found.law)) row.emplace_back(value);
    row.insert(row.end(), {p.target.impact.mass_eff, 100 * p.found.achieved.max_overlap / smaller(all, p.asked),
                           p.found.achieved.max_force});
    table.row(row);
  }
  note_soft(table, all);
  for (const Material& m : all.materials.all)
    if (!m.wall && !m.one_size())
      table.note(fmt::format("{}: at the middle of its radii, {} m", m.name,
                             console::significant(0.5 * (m.least + m.greatest), 6)));
  return table;
}

/// The pairs that have a law in the tangent plane.
Table tangential_table(const Answer& all) {
  std::vector<console::Column> columns{{"pair"}};
  for (const Parameter& p : parameters_of(all.materials.tangential))
    columns.push_back({std::string(p.name), p.unit(), {Notation::Kind::significant, 9}});
  columns.insert(columns.end(), {{"mu"}, {"beta0", "", {Notation::Kind::significant, 6}}});
  Table table(columns,
              fmt::format("In the tangent plane, {}: beta0 of a contact that sticks", text(all.materials.tangential)));
  for (const PairResult& p : all.found) {
    if (!p.tangential) continue;
    std::vector<Cell> row{all.between(p.asked)};
    for (const double value : values(p.tangential->law)) row.emplace_back(value);
    row.insert(row.end(), {p.tangential->mu ? Cell(*p.tangential->mu) : console::blank(), p.tangential->achieved});
    table.row(row);
  }
  return table;
}

Table size_table(const Answer& all) {
  Table table({{"pair"},
               {"radius", "m", three},
               {"other radius", "m", three},
               {"tcol", "s", {Notation::Kind::significant, 6}},
               {"en"},
               {"max overlap/radius", "%", three}},
              "The same numbers at the ends of the ranges of radii");
  for (const PairResult& p : all.found)
    for (const SizedContact& s : all.sizes(p)) {
      const bool parts = s.collision.separated();
      table.row({all.between(p.asked), s.radius_a, s.radius_b > 0 ? Cell(s.radius_b) : console::blank(),
                 parts ? Cell(s.collision.tcol) : console::blank(), parts ? Cell(s.collision.en) : console::blank(),
                 100 * s.collision.max_overlap / smaller(s)});
    }
  return table;
}

Table choice_table(const Answer& all) {
  Table table({{"engine"}, {"how"}, {"written by --export"}}, "What keeps en at every size");
  for (const SizeChoice& c : all.choices) {
    table.row({c.engine, c.how, c.written});
    if (!c.refusal.empty()) table.note(fmt::format("{}: not written here: {}", c.engine, c.refusal));
  }
  const bool in_overlap = all.materials.law.parameters().front().dimension.metre == 0;
  if (table.rows().empty())
    table.note(fmt::format("nothing: under this law en depends on size{}", in_overlap ? "" : " and velocity"));
  return table;
}

/// Rayleigh's time of the grain that has the shortest, where a grain's moduli are known and make a contact of its.
std::optional<double> rayleigh(const Materials& materials) {
  const auto moduli_count = [&](std::size_t i) {
    return std::any_of(materials.pairs.begin(), materials.pairs.end(),
                       [i](const Pair& p) { return (p.a == i || p.b == i) && !p.tcol && !p.stiffness; });
  };
  std::optional<double> least;
  for (std::size_t i = 0; i < materials.all.size(); ++i)
    if (const Material& m = materials.all[i]; !m.wall && m.solid && moduli_count(i)) {
      const double time = rayleigh_time(m.least, m.density, m.solid->young / materials.soften, m.solid->poisson);
      least = std::min(least.value_or(time), time);
    }
  return least;
}

Table steps_table(const Answer& all) {
  Table table({{"engine"}, {"error of en", "%"}, {"time step", "s", three}},
              "Time step that keeps en of every pair and size, wherever in a step the first touch falls");
  for (const EngineStep& s : all.steps)
    table.row({s.engine, 100 * s.error_en, s.step ? Cell(*s.step) : console::blank()});
  if (const auto time = rayleigh(all.materials))
    table.note(fmt::format("Rayleigh time of the smallest grain: {} s", console::significant(*time, 3)));
  for (const PairResult& p : all.found)
    if (const auto time = hertz_time_of(p.found.law, p.target.impact))
      table.note(fmt::format("Hertz time of {}: {} s", all.between(p.asked), console::significant(*time, 3)));
  return table;
}

Table missed_table(const Answer& all) {
  Table table({{"pair"}, {"why"}}, "Out of reach");
  for (const PairMissed& m : all.missed) table.row({all.between(m.asked), explained(m.why, Spelling::columns)});
  return table;
}

std::vector<Table> tables_of(const Answer& all) {
  std::vector<Table> tables;
  if (!all.found.empty()) tables.push_back(pair_table(all));
  if (Table tangential = tangential_table(all); !tangential.rows().empty()) tables.push_back(std::move(tangential));
  if (any_sizes(all.materials)) tables.push_back(size_table(all));
  if (any_sizes(all.materials) && all.missed.empty()) tables.push_back(choice_table(all));
  if (!all.found.empty()) tables.push_back(steps_table(all));
  if (!all.missed.empty()) tables.push_back(missed_table(all));
  return tables;
}

Json json_of(const SizedContact& s) {
  Json json{{"radii", {s.radius_a, s.radius_b > 0 ? Json(s.radius_b) : Json()}}, {"mass_eff", s.impact.mass_eff}};
  const bool parts = s.collision.separated();
  json["tcol"] = parts ? Json(s.collision.tcol) : Json();
  json["en"] = parts ? Json(s.collision.en) : Json();
  json["max_overlap"] = s.collision.max_overlap;
  return json;
}

Json json_of(const Answer& all, const PairResult& p) {
  Json json{{"between", {all.name(p.asked.a), all.name(p.asked.b)}},
            {"target", {{"tcol", p.target.tcol}, {"en", p.target.en}}},
            {"mass_eff", p.target.impact.mass_eff},
            {"radius_eff", p.radius_eff}};
  for (const NamedValue& v : parameters(p.found.law)) {
    json["parameters"][v.name] = v.value;
    if (!v.unit.empty()) json["units"][v.name] = v.unit;
  }
  json["achieved"] = {{"tcol", p.found.achieved.tcol}, {"en", p.found.achieved.en}};
  json["max_overlap"] = p.found.achieved.max_overlap;
  json["max_force"] = p.found.achieved.max_force;
  if (const auto time = hertz_time_of(p.found.law, p.target.impact)) json["hertz_time"] = *time;
  if (p.tangential) {
    Json& own = json["tangential"];
    own["law"] = text(p.tangential->form);
    const auto of_law = values(p.tangential->law);
    std::size_t i = 0;
    for (const Parameter& parameter : parameters_of(p.tangential->form)) {
      own["parameters"][std::string(parameter.name)] = of_law[i++];
      own["units"][std::string(parameter.name)] = parameter.unit();
    }
    own["parameters"]["mu"] = p.tangential->mu ? Json(*p.tangential->mu) : Json();
    own["beta0"] = p.tangential->beta0;
    own["achieved"] = {{"beta0", p.tangential->achieved}};
  }
  json["sizes"] = Json::array();
  for (const SizedContact& s : all.sizes(p)) json["sizes"].push_back(json_of(s));
  return json;
}

std::string document_of(const Answer& all) {
  Json json{{"schema", "ricochet/pairs/1"},
            {"law", all.materials.law.name()},
            {"end", text(all.materials.end)},
            {"velocity", all.materials.velocity},
            {"units",
             {{"velocity", "m/s"},
              {"tcol", "s"},
              {"mass_eff", "kg"},
              {"radius_eff", "m"},
              {"radii", "m"},
              {"max_overlap", "m"},
              {"max_force", "N"},
              {"hertz_time", "s"},
              {"rayleigh_time", "s"},
              {"step", "s"}}},
            {"pairs", Json::array()}};
  for (const PairResult& p : all.found) json["pairs"].push_back(json_of(all, p));
  json["timestep"] = Json::array();
  for (const EngineStep& s : all.steps)
    json["timestep"].push_back(
        {{"engine", s.engine}, {"error_en", s.error_en}, {"step", s.step ? Json(*s.step) : Json()}});
  if (const auto time = rayleigh(all.materials)) json["rayleigh_time"] = *time;
  if (any_sizes(all.materials)) {
    json["keeps_en"] = Json::array();
    for (const SizeChoice& c : all.choices) {
      json["keeps_en"].push_back({{"engine", c.engine}, {"how", c.how}, {"written", c.written}});
      if (!c.refusal.empty()) json["keeps_en"].back()["refusal"] = c.refusal;
    }
  }
  json["infeasible"] = Json::array();
  for (const PairMissed& m : all.missed)
    json["infeasible"].push_back(
        {{"between", {all.name(m.asked.a), all.name(m.asked.b)}}, {"reason", explained(m.why, Spelling::columns)}});
  return console::document(json);
}

/// CSV has the pairs alone.
std::string rendered(const Answer& all, console::Format format) {
  if (format == console::Format::json) return document_of(all);
  if (format == console::Format::csv) return pair_table(all).csv();
  return console::render_all(tables_of(all), format);
}

/// An engine's file has friction in every pair or in none.
void require_friction(const std::string& file, const Answer& all) {
  const auto rubs = [](const PairResult& p) { return p.tangential && p.tangential->mu; };
  for (const PairResult& p : all.found)
    if (rubs(p) != rubs(all.found.front()) || (p.tangential && !p.tangential->mu))
      throw console::BadInput(
          fmt::format("{}: pair {}: \"mu\" and the tangential part must be given of every pair or of "
                      "none with --export",
                      file, all.between(p.asked)));
}

}  // namespace

console::Exit run_materials(const Options& options) {
  take_only(options, "--materials", {"--materials", "--export", "--format", "--output"});
  Materials materials = read_materials(options.materials, console::read_input(options.materials));
  const auto engine = engine_named(options.engine);
  const Answer all = answer(options.materials, std::move(materials));
  console::Output output(options.output.file);
  if (engine && all.missed.empty()) {
    require_friction(options.materials, all);
    const Snippet snippet =
        export_contacts(*engine, contact_set(all.materials, all.found, kept_by(options.engine, all.materials.law)));
    output.write(exported({snippet}, *engine, options.output.format));
  } else {
    output.write(rendered(all, options.output.format));
  }
  output.commit();
  if (!all.missed.empty())
    throw console::Unreachable(fmt::format("pair {}: {}", all.between(all.missed.front().asked),
                                           explained(all.missed.front().why, Spelling::columns)));
  return console::Exit::done;
}

}  // namespace ricochet::calibration
