#include <calibrate/tangential.hpp>

#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <ricochet/collision/tangential_restitution.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>
#include <ricochet/support/text.hpp>

#include <boost/math/tools/minima.hpp>
#include <fmt/format.h>
#include <nlopt.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ricochet::calibration {
namespace {

using std::numbers::pi;

/// Friction that never slides, but where R itself vanishes.
constexpr double endless_friction = 1e9;

/// A sphere of the effective mass against a wall: the relative motion of any two homogeneous spheres. Its radius has no
/// part in velocities.
ObliqueImpact impact_at(const Impact& impact, double tangential) {
  return {.i = {.mass = impact.mass_eff, .radius = 1, .velocity = {tangential, 0, impact.velocity}}};
}

TangentialContact contact_of(const TangentialLaw& law, double mu) { return {.law = law, .friction = {mu, mu, 0}}; }

/// What a contact that sticks throughout does: β₀, and the strain that is left over, in u_t t_col.
struct Stuck {
  double beta = 0, strain = 0;
};

/// The contact that sticks, under one normal law at one impact, in units of m_t = 2m/7 and t_col.
class Sticking {
 public:
  Sticking(const AnyLaw& normal, ContactEnd end, const Impact& impact, double tcol)
      : normal_(normal), end_(end), impact_(impact), tcol_(tcol) {}

  double mass() const { return tangential_mass_ratio * impact_.mass_eff; }
  double tcol() const { return tcol_; }
  std::size_t evaluations() const { return evaluations_; }

  Stuck operator()(const TangentialLaw& law) const {
    ++evaluations_;
    const double slip = impact_.velocity;
    const auto out = collide(normal_, contact_of(law, endless_friction), impact_at(impact_, slip), {.end = end_});
    if (!out.separated() || !out.beta) throw NotConverged("the oblique collision could not be followed");
    const double k = spring(law, out.normal.max_overlap).stiffness;
    return {*out.beta, std::sqrt(2 * std::max(0.0, out.lost.stored) / k) / (slip * tcol_)};
  }

 private:
  const AnyLaw& normal_;
  ContactEnd end_;
  Impact impact_;
  double tcol_;
  mutable std::size_t evaluations_ = 0;
};

/// An elastic spring whose repulsion lasts t_col: what sticks does not know the normal law.
Linear lasting(double tcol, double mass_eff) { return Linear(mass_eff * std::pow(pi / tcol, 2), 0); }

/// From ln of the parameters over their units, m_t/t², m_t/t and, of mindlin, √m less.
TangentialLaw law_at(TangentialForm form, std::span<const double> x, const Sticking& stuck, double unit_k) {
  const double k = unit_k * std::exp(x[0]);
  if (form == TangentialForm::mindlin) return MindlinTangential(k);
  return LinearTangential(k, x.size() > 1 ? stuck.mass() / stuck.tcol() * std::exp(x[1]) : 0);
}

/// The search's view: the squared misses of β₀ and, of the damped form, of the strain.
struct Miss {
  TangentialForm form;
  double beta0 = 0, unit_k = 0;
  const Sticking& stuck;
  std::vector<double> best = {};
  double least = std::numeric_limits<double>::max();

  double operator()(const std::vector<double>& x) {
    const Stuck out = stuck(law_at(form, x, stuck, unit_k));
    const double strain = form == TangentialForm::linear ? out.strain : 0;
    const double sum = std::pow(out.beta - beta0, 2) + strain * strain;
    if (sum < least) {
      least = sum;
      best = x;
    }
    return sum;
  }
};

double objective(const std::vector<double>& x, std::vector<double>&, void* data) {
  return (*static_cast<Miss*>(data))(x);
}

/// Where the search ended, and by how much its point misses β₀ and, of the damped form, the strain of 0.
struct Searched {
  TangentialLaw law;
  double miss = 0;
};

/// BOBYQA within a factor e of `ours` and below `highest`, ln of the first parameter, where another period of the
/// spring begins; begun a factor √e away, and anew around its best point while that gains.
Searched searched(TangentialForm form, double beta0, double unit_k, const TangentialLaw& ours, double highest,
                  const Sticking& stuck) {
  const auto parameters = values(ours);
  const double log_k = std::log(parameters.at(0) / unit_k);
  std::vector<double> low{log_k - 1}, high{std::min(log_k + 1, highest)}, x{log_k - 0.5};
  if (parameters.at(1) > 0) {
    const double log_c = std::log(parameters.at(1) * stuck.tcol() / stuck.mass());
    low.push_back(log_c - 1);
    high.push_back(log_c + 1);
    x.push_back(log_c + 0.5);
  }
  Miss miss{form, beta0, unit_k, stuck, x};
  double step = 0.25;
  for (double before = std::numeric_limits<double>::infinity(); miss.least > 1e-24 && miss.least < 0.25 * before;) {
    before = miss.least;
    nlopt::opt optimizer(nlopt::LN_BOBYQA, static_cast<unsigned>(x.size()));
    optimizer.set_min_objective(objective, &miss);
    optimizer.set_lower_bounds(low);
    optimizer.set_upper_bounds(high);
    optimizer.set_stopval(1e-26);
    optimizer.set_xtol_rel(1e-14);
    optimizer.set_maxeval(200);
    optimizer.set_initial_step(step);
    x = miss.best;
    double value = 0;
    try {
      optimizer.optimize(x, value);
    } catch (const std::runtime_error&) {  // rounding is all that is left; the best point counts
    }
    step = std::clamp(std::sqrt(miss.least), 1e-9, 0.25);
  }
  return {law_at(form, miss.best, stuck, unit_k), std::sqrt(miss.least)};
}

double apart(const TangentialLaw& law, const TangentialLaw& other) {
  const auto ours = values(law), theirs = values(other);
  double greatest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (const double size = std::max(ours[i], theirs[i]); size > 0)
      greatest = std::max(greatest, std::abs(ours[i] - theirs[i]) / size);
  return greatest;
}

Infeasible beyond(const AnyLaw& normal, ContactEnd end, double beta0, double lowest, double highest,
                  const std::string& reason) {
  return {.law = LawKind::of(normal),
          .end = end,
          .reason = reason,
          .quantity = "beta0",
          .asked = beta0,
          .lowest = lowest,
          .highest = highest};
}

/// The first rise of β₀ with ln k: from no spring, −1, to its top. k in units of `unit`.
struct FirstRise {
  double log_low = 0, log_top = 0, top = -1;
};

template <class F>
FirstRise first_rise(const F& beta) {
  constexpr double step = 0.25;
  FirstRise rise{-9, -9, -1};
  double x = -9;
  for (double here = beta(x); here >= rise.top && x < 8; here = beta(x)) {
    rise.top = here;
    rise.log_top = x;
    x += step;
  }
  double low = rise.log_top - step, high = rise.log_top + step;  // the top lies between
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) * 0.382, b = low + (high - low) * 0.618;
    (beta(a) < beta(b) ? low : high) = beta(a) < beta(b) ? a : b;
  }
  rise.log_top = 0.5 * (low + high);
  rise.top = beta(rise.log_top);
  return rise;
}

/// k_t √ζ for β₀ without dashpot.
struct MindlinSpring {
  MindlinTangential law;
  double log_top = 0;  ///< of the first rise, in units of `unit_k`
};
std::variant<MindlinSpring, Infeasible> spring_for(double beta0, const AnyLaw& normal, ContactEnd end,
                                                   const Sticking& stuck, double unit_k) {
  const auto beta = [&](double log_k) { return stuck(MindlinTangential(unit_k * std::exp(log_k))).beta; };
  const FirstRise rise = first_rise(beta);
  if (!(beta0 > -1 && beta0 <= rise.top)) {
    Infeasible out = beyond(normal, end, beta0, -1, rise.top,
                            "-1 is no spring at all, and what a shrinking contact lets go no spring gives back");
    out.low_open = true;
    return out;
  }
  const double low = beta(rise.log_low);
  if (beta0 <= low) return beyond(normal, end, beta0, low, rise.top, "so weak a spring is none");
  const double log_k = support::root([&](double x) { return beta(x) - beta0; }, rise.log_low, rise.log_top, low - beta0,
                                     rise.top - beta0);
  return MindlinSpring{MindlinTangential(unit_k * std::exp(log_k)), rise.log_top};
}

/// β₀ under a dashpot.
struct Damped {
  double log_c = 0, beta = 0;
};

/// Of samples over ln c in steps of `step`, the one of the greatest sign·β₀, moved to the maximum between its
/// neighbours by Brent's method.
template <class F>
Damped extreme(const F& beta, const std::vector<Damped>& all, double step, double sign) {
  const auto best = std::max_element(all.begin(), all.end(),
                                     [&](const Damped& a, const Damped& b) { return sign * a.beta < sign * b.beta; });
  if (best == all.begin() || best == all.end() - 1) return *best;
  const auto [x, value] = boost::math::tools::brent_find_minima([&](double log_c) { return -sign * beta(log_c); },
                                                                best->log_c - step, best->log_c + step, 26);
  return -value > sign * best->beta ? Damped{x, -sign * value} : *best;
}

/// The least c_t that gives β₀ beside Mindlin's spring k_t √ζ. No dashpot leaves β₀ to the free spring, an endless one
/// makes it 0; between them it is not monotone, so that its extremes are sought as well.
std::variant<MindlinTangential, Infeasible> dashpot_for(double beta0, double k, const AnyLaw& normal, ContactEnd end,
                                                        const Sticking& stuck) {
  constexpr double step = 0.25;
  const double unit_c = stuck.mass() / stuck.tcol(), free = stuck(MindlinTangential(k)).beta;
  if (beta0 == free) return MindlinTangential(k);
  const auto with = [&](double c) { return stuck(MindlinTangential(k, c)).beta; };
  const auto beta = [&](double log_c) { return with(unit_c * std::exp(log_c)); };
  const auto within = [&](double low, double high) {
    return MindlinTangential(k,
                             support::root([&](double c) { return with(c) - beta0; }, low, high, {.relative = 1e-13}));
  };
  constexpr int first = -40, last = 24;
  std::vector<Damped> all;
  all.reserve(last - first + 1);
  for (int i = first; i <= last; ++i) {
    all.push_back({step * i, beta(step * i)});
    const double before = i == first ? free : all.rbegin()[1].beta;
    const double low = i == first ? 0.0 : std::exp(step * (i - 1));
    if ((all.back().beta > beta0) != (before > beta0)) return within(unit_c * low, unit_c * std::exp(step * i));
  }
  double lowest = std::min(free, 0.0), highest = std::max(free, 0.0);
  for (const double sign : {-1.0, 1.0}) {
    const Damped far = extreme(beta, all, step, sign);
    if (sign * far.beta >= sign * beta0 && sign * beta0 > sign * free)
      return within(unit_c * std::exp(far.log_c - step), unit_c * std::exp(far.log_c));
    lowest = std::min(lowest, far.beta);
    highest = std::max(highest, far.beta);
  }
  Infeasible out = beyond(normal, end, beta0, lowest, highest, "no dashpot beside the spring of these moduli gives it");
  out.low_open = lowest == 0 && free > 0;
  out.open = highest == 0 && free < 0;
  return out;
}

/// Says where the contact itself does otherwise than one that sticks for all of t_col.
void tell_of_end(TangentialCalibration& out, ContactEnd end) {
  const bool overlap = end == ContactEnd::overlap;
  if (std::abs(out.achieved - out.beta0) < (overlap ? 1e-9 : 1e-6)) return;
  out.remarks.push_back(
      fmt::format("beta0 is that of a contact that sticks for all of tcol; this one's repulsion{}, where beta0 is {}",
                  overlap ? ", and friction with it, ends before its overlap does"
                          : fmt::format(" falls so low before it ends that even friction of mu = {} slides",
                                        support::shortest(endless_friction)),
                  support::significant(out.achieved, 4)));
}

/// The search's difference, and a remark where it is more than the collision's own error explains.
void cross_check(TangentialCalibration& out, const Searched& found) {
  out.cross_difference = apart(out.law, found.law);
  if (*out.cross_difference <= 1e-6) return;
  out.remarks.push_back(fmt::format(
      "the search ends at parameters that differ by up to {} and miss by {}: beta0 hardly tells them from these",
      support::significant(*out.cross_difference, 1), support::significant(found.miss, 1)));
}

TangentialOutcome of_linear_form(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                                 const Target& target) {
  const double beta0 = *request.beta0, m = target.impact.mass_eff;
  if (auto missed = out_of_form(request.form, beta0, LawKind::of(normal), end)) return *missed;
  const auto form = request.form == TangentialForm::linear ? StickingForm::damped : StickingForm::undamped;
  const LinearTangential law = tangential_for(beta0, target.tcol, m, form);
  TangentialCalibration out{.form = request.form, .law = law, .mu = request.mu, .beta0 = beta0};
  out.algorithm = "closed form";
  out.achieved = Sticking(normal, end, target.impact, target.tcol)(law).beta;
  const AnyLaw elastic = lasting(target.tcol, m);
  const Sticking stuck(elastic, ContactEnd::force, target.impact, target.tcol);
  const double unit_k = stuck.mass() / (target.tcol * target.tcol);
  // Without a dashpot β₀ = −cos(√(k_t/m_t) t_col) falls again beyond half a period.
  const double highest = form == StickingForm::undamped ? 2 * std::log(pi) : std::numeric_limits<double>::infinity();
  cross_check(out, searched(request.form, beta0, unit_k, law, highest, stuck));
  out.evaluations = stuck.evaluations();
  return out;
}

TangentialOutcome of_mindlin(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                             const Target& target) {
  const Sticking stuck(normal, end, target.impact, target.tcol);
  TangentialCalibration out{.form = request.form, .law = MindlinTangential(1), .mu = request.mu};
  if (!request.beta0) {
    out.law = MindlinTangential(request.mindlin.value());
    out.achieved = out.beta0 = stuck(out.law).beta;
    out.algorithm = "moduli";
    return out;
  }
  out.beta0 = *request.beta0;
  out.algorithm = "bracketed root";
  if (request.mindlin) {
    const auto found = dashpot_for(out.beta0, *request.mindlin, normal, end, stuck);
    if (const auto* missed = std::get_if<Infeasible>(&found)) return *missed;
    out.law = std::get<MindlinTangential>(found);
    out.achieved = stuck(out.law).beta;
    return out;
  }
  const double deepest = collide(normal, target.impact, {.end = end}).max_overlap;
  const double unit_k = stuck.mass() / (target.tcol * target.tcol * std::sqrt(deepest));
  const auto found = spring_for(out.beta0, normal, end, stuck, unit_k);
  if (const auto* missed = std::get_if<Infeasible>(&found)) return *missed;
  const auto& spring = std::get<MindlinSpring>(found);
  out.law = spring.law;
  out.achieved = stuck(out.law).beta;
  const Sticking again(normal, end, target.impact, target.tcol);
  cross_check(out, searched(request.form, out.beta0, unit_k, out.law, spring.log_top, again));
  out.evaluations = again.evaluations();
  return out;
}

}  // namespace

std::string_view text(TangentialForm form) noexcept {
  constexpr std::string_view words[] = {"linear", "linear-undamped", "mindlin"};
  return words[static_cast<std::size_t>(form)];
}

std::optional<TangentialForm> tangential_form(std::string_view name) noexcept {
  for (const auto form : {TangentialForm::linear, TangentialForm::undamped, TangentialForm::mindlin})
    if (text(form) == name) return form;
  return std::nullopt;
}

std::optional<Infeasible> out_of_form(TangentialForm form, double beta0, LawKind normal, ContactEnd end) {
  if (form == TangentialForm::mindlin) return std::nullopt;
  const bool damped = form == TangentialForm::linear;
  const double lowest = damped ? 0 : -1;
  if (beta0 > lowest && beta0 <= 1) return std::nullopt;
  return Infeasible{.law = normal,
                    .end = end,
                    .reason = damped ? "a spring and a dashpot after half a period; linear-undamped goes down to -1"
                                     : "-1 is no spring at all, 1 a full reversal",
                    .quantity = "beta0",
                    .asked = beta0,
                    .lowest = lowest,
                    .highest = 1,
                    .low_open = true};
}

std::span<const Parameter> parameters_of(TangentialForm form) noexcept {
  if (form == TangentialForm::mindlin) return MindlinTangential::parameters;
  return LinearTangential::parameters;
}

double mindlin_stiffness(double young, double poisson, double young2, double poisson2, double radius_eff) {
  contact_modulus({young, poisson}, {young2, poisson2});  // which checks the moduli
  support::require_positive("radius_eff", radius_eff);
  const auto softness = [](double e, double nu) { return (2 - nu) * 2 * (1 + nu) / e; };
  return 8 / (softness(young, poisson) + softness(young2, poisson2)) * std::sqrt(radius_eff);
}

TangentialOutcome calibrate_tangential(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                                       const Target& target) {
  if (request.mu) support::require_not_negative("mu", *request.mu);
  if (!request.beta0 && !(request.form == TangentialForm::mindlin && request.mindlin))
    throw std::invalid_argument("beta0: missing: must be given");
  TangentialOutcome outcome = request.form == TangentialForm::mindlin ? of_mindlin(request, normal, end, target)
                                                                      : of_linear_form(request, normal, end, target);
  if (auto* found = std::get_if<TangentialCalibration>(&outcome)) tell_of_end(*found, end);
  return outcome;
}

std::vector<double> usual_angles() {
  std::vector<double> angles;
  angles.reserve(17);
  for (int degrees = 5; degrees <= 85; degrees += 5) angles.push_back(degrees * pi / 180);
  return angles;
}

std::vector<ObliqueRebound> rebounds(const TangentialLaw& law, double mu, const AnyLaw& normal, ContactEnd end,
                                     const Impact& impact, std::span<const double> angles) {
  const TangentialContact contact = contact_of(law, mu);
  std::vector<ObliqueRebound> all;
  all.reserve(angles.size());
  for (const double angle : angles) {
    support::require(angle > 0 && angle < pi / 2, "angle", angle, "in (0, pi/2)");
    const auto out = collide(normal, contact, impact_at(impact, impact.velocity * std::tan(angle)), {.end = end});
    if (!out.separated()) throw NotConverged("the oblique collision could not be followed");
    all.push_back({.angle = angle,
                   .et = out.et.value(),
                   .beta = out.beta.value(),
                   .rebound_angle = std::atan2(out.velocity_i.x, -out.velocity_i.z),
                   .impulse_ratio = out.impulse_ratio});
  }
  return all;
}

namespace {

/// e_t over the angles of a changed target and request; the tangential law as it is found for them, or `held`.
std::vector<double> changed(const TangentialRequest& request, LawKind kind, ContactEnd end, const Target& target,
                            std::span<const double> angles, const TangentialLaw* held) {
  const auto unit = unit_law(kind, target.en, end);
  const auto normal = unit ? at_impact(unit->law, target.tcol, target.impact) : std::nullopt;
  if (!normal) throw std::invalid_argument("no double carries the changed law");
  TangentialLaw law = RigidTangential{};
  if (held) {
    law = *held;
  } else {
    const TangentialOutcome found = calibrate_tangential(request, *normal, end, target);
    if (!std::holds_alternative<TangentialCalibration>(found)) throw std::invalid_argument("beta0 at its end");
    law = std::get<TangentialCalibration>(found).law;
  }
  std::vector<double> all;
  for (const ObliqueRebound& r : rebounds(law, request.mu.value(), *normal, end, target.impact, angles))
    all.push_back(r.et);
  return all;
}

}  // namespace

std::vector<ObliqueSensitivity> sensitivities(const TangentialCalibration& found, const TangentialRequest& request,
                                              LawKind normal, ContactEnd end, const Target& target,
                                              std::span<const double> angles) {
  constexpr double share = 1e-3, percent = 0.01 / (2 * share);
  std::vector<ObliqueSensitivity> all;
  for (const double angle : angles) all.push_back({.angle = angle});
  const auto add = [&](double ObliqueSensitivity::*member, const TangentialLaw* held, auto change) {
    TangentialRequest up = request, down = request;
    Target target_up = target, target_down = target;
    change(up, target_up, 1 + share);
    change(down, target_down, 1 - share);
    const auto above = changed(up, normal, end, target_up, angles, held);
    const auto below = changed(down, normal, end, target_down, angles, held);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].*member = percent * (above[i] - below[i]);
  };
  const TangentialLaw* law = &found.law;
  add(&ObliqueSensitivity::tcol, law, [](TangentialRequest&, Target& t, double factor) { t.tcol *= factor; });
  add(&ObliqueSensitivity::en, law, [](TangentialRequest&, Target& t, double factor) { t.en *= factor; });
  add(&ObliqueSensitivity::mu, law, [](TangentialRequest& r, Target&, double factor) { *r.mu *= factor; });
  if (request.beta0 && *request.beta0 != 0)
    add(&ObliqueSensitivity::beta0, nullptr, [](TangentialRequest& r, Target&, double factor) { *r.beta0 *= factor; });
  return all;
}

}  // namespace ricochet::calibration
