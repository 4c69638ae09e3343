#include <calibrate/known.hpp>
#include <calibrate/materials.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ricochet::calibration {
namespace {

/// Two bodies of given sizes; the second radius of a wall is 0.
struct Bodies {
  double radius_a = 0, radius_b = 0, radius_eff = 0, mass_eff = 0;
};

Bodies bodies_of(const Materials& m, const Pair& pair, double radius_a, double radius_b) {
  const Material &a = m.all[pair.a], &b = m.all[pair.b];
  const double mass = a.mass(radius_a);
  if (b.wall) return {radius_a, 0, radius_a, mass};
  return {radius_a, radius_b, radius_a / (1 + radius_a / radius_b), mass / (1 + mass / b.mass(radius_b))};
}

double middle(const Material& m) { return 0.5 * (m.least + m.greatest); }

Scale scale_of(const Materials& m, const Pair& pair, double radius_eff) {
  const Material &a = m.all[pair.a], &b = m.all[pair.b];
  if (pair.tcol) return scale::CollisionTime{*pair.tcol};
  if (pair.stiffness) return scale::Stiffness{*pair.stiffness};
  if (a.solid && b.solid) return scale::Moduli{*a.solid, *b.solid, radius_eff, m.soften, m.match};
  if (a.stiffness && b.stiffness) return scale::Stiffness{2 / (1 / *a.stiffness + 1 / *b.stiffness)};
  throw std::invalid_argument(
      "a pair needs a collision time, a stiffness, or materials that have moduli or stiffnesses");
}

/// The law of other bodies than those that it was calibrated for.
struct Resized {
  const Bodies &from, &to;
  Kept kept;

  double root() const { return std::sqrt(to.radius_eff / from.radius_eff); }
  double mass() const { return to.mass_eff / from.mass_eff; }

  template <class Law>
  AnyLaw operator()(const Law& law) const {
    return law;
  }
  AnyLaw operator()(const Linear& law) const {
    if (kept == Kept::target) return Linear(law.k() * mass(), law.c() * mass());
    return Linear(law.k(), kept == Kept::restitution ? law.c() * std::sqrt(mass()) : law.c());
  }
  AnyLaw operator()(const Fractional& law) const {
    const double share = kept == Kept::target ? mass() : 1;  // of c^α k^{1−α}
    return Fractional(law.k() * share, law.c() * share, law.alpha());
  }
  AnyLaw operator()(const Tsuji& law) const { return Tsuji(law.k() * root(), law.c() * std::sqrt(root() * mass())); }
  AnyLaw operator()(const FractionalHertz& law) const {
    return FractionalHertz(law.k() * root(), law.c() * root(), law.alpha());
  }
  AnyLaw operator()(const KuwabaraKono& law) const { return KuwabaraKono(law.k() * root(), law.c() * root()); }
};

Bodies middle_bodies(const Materials& m, const Pair& pair) {
  return bodies_of(m, pair, middle(m.all[pair.a]), middle(m.all[pair.b]));
}

/// Mindlin's k_t is that of the moduli, where both materials have them.
std::optional<TangentialRequest> tangential_of(const Materials& m, const Pair& pair, double radius_eff) {
  if (!pair.beta0 && !pair.mu) return std::nullopt;
  TangentialRequest request{.form = m.tangential, .beta0 = pair.beta0, .mu = pair.mu};
  const auto &a = m.all[pair.a].solid, &b = m.all[pair.b].solid;
  if (m.tangential == TangentialForm::mindlin && a && b && !pair.tcol && !pair.stiffness)
    request.mindlin = mindlin_stiffness(a->young, a->poisson, b->young, b->poisson, radius_eff) / m.soften;
  return request;
}

PairOutcome calibrated(const Materials& m, const Pair& pair) {
  const Bodies at = middle_bodies(m, pair);
  const Known known{scale_of(m, pair, at.radius_eff), loss::Restitution{pair.en}, {m.velocity, at.mass_eff}, m.held};
  const auto request = request_of(m.law, m.end, known);
  if (const auto* missed = std::get_if<Infeasible>(&request)) return PairMissed{pair, *missed};
  const Outcome outcome = calibrate(std::get<Request>(request), {.method = Method::direct});
  if (const auto* missed = std::get_if<Infeasible>(&outcome)) return PairMissed{pair, *missed};
  PairResult found{pair, std::get<Calibration>(outcome), std::get<Request>(request).target, at.radius_eff};
  if (const auto wanted = tangential_of(m, pair, at.radius_eff)) {
    const auto tangential = calibrate_tangential(*wanted, found.found.law, m.end, found.target);
    if (const auto* missed = std::get_if<Infeasible>(&tangential)) return PairMissed{pair, *missed};
    found.tangential = std::get<TangentialCalibration>(tangential);
  }
  return found;
}

/// The steps of one engine over every pair and size; nothing where it does not run them all.
std::vector<EngineStep> steps_in(const std::string& engine, const Materials& materials,
                                 const std::vector<PairResult>& pairs) {
  std::vector<EngineStep> least;
  bool runs_all = true;
  const auto take = [&](const AnyLaw& law, const Target& target) {
    std::vector<EngineStep> own;
    for (const EngineStep& s : engine_steps(law, materials.end, target))
      if (s.engine == engine) own.push_back(s);
    runs_all = runs_all && !own.empty();
    if (least.empty()) least = own;
    for (std::size_t i = 0; runs_all && i < own.size(); ++i)
      least[i].step =
          own[i].step && least[i].step ? std::optional(std::min(*own[i].step, *least[i].step)) : std::nullopt;
  };
  for (const PairResult& p : pairs) {
    take(p.found.law, p.target);
    for (const SizedContact& s : over_sizes(materials, p, kept_by(engine, materials.law)))
      if (s.collision.separated()) take(s.law, {s.collision.tcol, s.collision.en, s.impact});
  }
  return runs_all ? least : std::vector<EngineStep>{};
}

}  // namespace

double Material::mass(double radius) const { return sphere_mass(radius, density); }

std::vector<PairOutcome> calibrate_pairs(const Materials& materials) {
  std::vector<PairOutcome> all;
  for (const Pair& pair : materials.pairs) {
    try {
      all.push_back(calibrated(materials, pair));
    } catch (const std::invalid_argument& misuse) {
      throw std::invalid_argument(
          fmt::format("pair {}, {}: {}", materials.all[pair.a].name, materials.all[pair.b].name, misuse.what()));
    }
  }
  return all;
}

std::vector<SizedContact> over_sizes(const Materials& m, const PairResult& result, Kept kept) {
  const Pair& pair = result.asked;
  const Material &a = m.all[pair.a], &b = m.all[pair.b];
  const Bodies from = middle_bodies(m, pair);
  std::vector<SizedContact> all;
  const auto add = [&](double radius_a, double radius_b) {
    const Bodies to = bodies_of(m, pair, radius_a, radius_b);
    const Impact impact{m.velocity, to.mass_eff};
    const AnyLaw law = std::visit(Resized{from, to, kept}, result.found.law);
    all.push_back({radius_a, to.radius_b, to.radius_eff, impact, law, collide(law, impact, {.end = m.end})});
  };
  if (a.one_size() && b.one_size()) return all;
  add(a.least, b.least);
  if (pair.a != pair.b && !a.one_size() && !b.one_size()) add(a.greatest, b.least);
  if (!b.one_size()) add(a.least, b.greatest);
  if (!a.one_size()) add(a.greatest, b.greatest);
  return all;
}

ContactSet contact_set(const Materials& materials, const std::vector<PairResult>& pairs, Kept kept) {
  ContactSet set;
  set.end = materials.end;
  for (const Material& m : materials.all) {
    BodyKind kind{.name = m.name, .wall = m.wall};
    if (!m.wall) kind.density = m.density;
    if (m.solid) kind.poisson = m.solid->poisson;
    set.kinds.push_back(kind);
  }
  // An engine's file has friction in every pair or in none.
  const bool rubs =
      std::all_of(pairs.begin(), pairs.end(), [](const PairResult& p) { return p.tangential && p.tangential->mu; });
  for (const PairResult& p : pairs) {
    set.pairs.push_back({p.asked.a, p.asked.b, p.found.law, p.target.tcol, p.target.en, p.target.impact, p.radius_eff});
    if (rubs) set.pairs.back().tangential = TangentialPart{p.tangential->law, p.tangential->mu.value()};
    for (const SizedContact& s : over_sizes(materials, p, kept))
      set.other_sizes.push_back(
          {p.asked.a, p.asked.b, s.law, s.collision.tcol, s.collision.en, s.impact, s.radius_eff});
  }
  return set;
}

std::vector<SizeChoice> size_choices(LawKind law) {
  if (law == kind_of<Linear>)
    return {
        {"lammps", "damping coeff_restitution, before June 2024 damping tsuji, with hooke", Kept::restitution, true},
        {"liggghts", "model hooke with coefficientRestitution; its k follows from moduli and a velocity",
         Kept::restitution, false},
        {"yade", "tc and en of Ip2_ViscElMat_ViscElMat_ViscElPhys, which keep tcol as well", Kept::target, true},
        {"mfix", "LSD, which takes a restitution; one grain and its wall", Kept::restitution, true}};
  if (law == kind_of<Tsuji>)
    return {{"liggghts", "model hertz with coefficientRestitution", Kept::numbers, true},
            {"lammps", "damping coeff_restitution, before June 2024 damping tsuji", Kept::numbers, true},
            {"yade", "betan of Ip2_FrictMat_FrictMat_MindlinPhys", Kept::numbers, true},
            {"mercurydpm", "setDissipation of HertzianViscoelasticSpecies", Kept::numbers, true},
            {"mfix", "HERTZIAN, which takes a restitution; one grain and its wall", Kept::numbers, true}};
  if (law == kind_of<Hysteretic>)
    return {{"mercurydpm", "k1 and k2: en = sqrt(k1/k2) at every size", Kept::numbers, true}};
  if (law == kind_of<Fractional>)
    return {
        {"liggghts-ricochet", "collisionTime and coefficientRestitution, which keep tcol as well", Kept::target, true},
        {"lammps-ricochet", "fractional/target, which keeps tcol as well", Kept::target, true}};
  return {};
}

namespace {

/// What is written for the pairs in that engine along the normal.
Snippet written(std::string_view engine, const Materials& materials, const std::vector<PairResult>& pairs, Kept kept) {
  const Engine known = engine_run_by(engine).value();
  ContactSet set = contact_set(materials, pairs, kept);
  for (PairCase& pair : set.pairs) pair.tangential.reset();
  return export_contacts(known, set);
}

}  // namespace

std::vector<SizeChoice> size_choices(const Materials& materials, const std::vector<PairResult>& pairs) {
  std::vector<SizeChoice> all = size_choices(materials.law);
  for (SizeChoice& choice : all) {
    if (!choice.written) continue;
    const Snippet snippet = written(choice.engine, materials, pairs, choice.kept);
    choice.written = snippet.fidelity != Fidelity::absent;
    if (choice.written) continue;
    choice.refusal = snippet.remarks.empty() ? "a contact never separates there" : snippet.remarks.front();
    if (const std::string mark = "NOT WRITTEN: "; choice.refusal.starts_with(mark))
      choice.refusal.erase(0, mark.size());
  }
  return all;
}

Kept kept_by(std::string_view engine, LawKind law) {
  for (const SizeChoice& choice : size_choices(law))
    if (choice.written && choice.engine.starts_with(engine)) return choice.kept;
  return Kept::numbers;
}

std::vector<EngineStep> engine_steps(const Materials& materials, const std::vector<PairResult>& pairs) {
  std::vector<EngineStep> all;
  if (pairs.empty()) return all;
  const Target& target = pairs.front().target;
  std::string last;
  for (const EngineStep& s : engine_steps(pairs.front().found.law, materials.end, target)) {
    if (std::exchange(last, s.engine) == s.engine) continue;
    const bool all_found = pairs.size() == materials.pairs.size();
    if (all_found && written(s.engine, materials, pairs, kept_by(s.engine, materials.law)).fidelity == Fidelity::absent)
      continue;
    for (const EngineStep& step : steps_in(s.engine, materials, pairs)) all.push_back(step);
  }
  return all;
}

}  // namespace ricochet::calibration
