#include <calibrate/advice.hpp>

#include "solution.hpp"

#include <calibrate/export.hpp>
#include <half_step_contact.hpp>
#include <run_watch.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <ricochet/fractional/memory_kernel.hpp>
#include <ricochet/support/require.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace ricochet::calibration {
namespace {

AnyLaw with(const AnyLaw& law, std::size_t changed, double value) {
  std::vector<double> all = values(law);
  all.at(changed) = value;
  return LawKind::of(law).with(all);
}

/// The collision with one parameter moved; nothing where there is no such law or its contact does not end.
std::optional<Collision> moved(const AnyLaw& law, std::size_t i, double value, ContactEnd end, const Impact& impact) {
  try {
    const Collision collision = collide(with(law, i, value), impact, {.end = end});
    return collision.separated() ? std::optional(collision) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Of a contact that has not ended.
constexpr double endless = std::numeric_limits<double>::infinity();

/// Restitution of a contact that begins `lead` of a step before the end of the step in which it is found.
template <ContactLaw Law>
double stepped_restitution(const Law& law, ContactEnd end, const Impact& impact, double h, double lead,
                           int most_steps) {
  typename Law::Memory memory{};
  double overlap = (lead - 1) * h * impact.velocity, rate = impact.velocity, force = 0;
  Approach before{0, rate};
  for (int n = 0; n < most_steps; ++n) {
    const double half = rate - 0.5 * h * force / impact.mass_eff;
    overlap += h * half;
    if (overlap <= 0) return -half / impact.velocity;
    const Approach now{overlap, half};
    law.advance(memory, before, now, n == 0 ? lead * h : h);
    force = law.force(now, memory);
    if (end == ContactEnd::force && force <= 0) return -half / impact.velocity;
    before = now;
    rate = half - 0.5 * h * force / impact.mass_eff;
  }
  return endless;
}

/// The same in the drivers, whose contact finds both its ends.
template <class Contact>
double located_restitution(const Contact& contact, const Impact& impact, double h, double lead, int most_steps) {
  std::array<double, half_step::HalfStepContact::size> history{};
  double overlap = (lead - 1) * h * impact.velocity, rate = impact.velocity, force = 0;
  for (int n = 1; n <= most_steps; ++n) {
    const double half = rate - 0.5 * h * force / impact.mass_eff;
    overlap += h * half;
    if (overlap <= 0) return -half / impact.velocity;
    contact.advance(history.data(), n, overlap, half, h);
    force = contact.repulsion(history.data());
    if (n > 1 && force <= 0) return -half / impact.velocity;
    rate = half - 0.5 * h * force / impact.mass_eff;
  }
  return endless;
}

/// Over places of the touch, in steps before the first that feels it: restitution(lead) against the target's. The
/// worst place is often the first or the last.
template <class F>
double worst_error(const Target& target, const F& restitution) {
  constexpr int places = 16;
  constexpr double edge = 1e-6;
  double worst = 0;
  const auto look = [&](double lead) {
    if (const double error = std::abs(restitution(lead) / target.en - 1); !(error <= worst)) worst = error;
  };
  look(edge);
  for (int place = 0; place < places; ++place) look((place + 0.5) / places);
  look(1 - edge);
  return worst;
}

/// A contact that takes this many times the collision time does not end.
constexpr int patience = 20;

int most_steps(double steps) { return static_cast<int>(std::ceil(patience * steps)); }

struct Stepped {
  ContactEnd end;
  const Target& target;
  double steps;

  template <class Law>
  double operator()(const Law& law) const {
    const double h = target.tcol / steps;
    return worst_error(
        target, [&](double lead) { return stepped_restitution(law, end, target.impact, h, lead, most_steps(steps)); });
  }
  template <RemembersAll Law>
  double operator()(const Law& law) const {
    using Arms = typename Law::Arms;
    const double h = target.tcol / steps;
    const MemoryWindow window{h, 10 * target.tcol, 1e-6};
    return (*this)(Arms(law, affordable_kernel(law.alpha(), window, Arms::max_kernel_arms), h));
  }
};

/// The drivers' contact in units of the step: its memory is a number of steps, so that the kernel, which takes
/// most of the time here, is the same for all of them. With τ = t/h and D_t^α = h^{−α} D_τ^α mζ'' = −R keeps its form
/// for velocities v h and the law whose parameters are counted in steps, its R multiplied by h².
template <class Law>
class Located {
 public:
  Located(const Law& law, const Target& target)
      : law_(law), target_(target), kernel_(affordable_kernel(law.alpha(), {1, memory, 1e-7}, most_arms)) {}

  double error(double steps) const {
    const double h = target_.tcol / steps;
    const half_step::LocatedContact<Law> contact(in_steps(h), kernel_, 1);
    const Impact impact{target_.impact.velocity * h, target_.impact.mass_eff};
    return worst_error(target_,
                       [&](double lead) { return located_restitution(contact, impact, 1, lead, most_steps(steps)); });
  }

 private:
  static constexpr int memory = 1000;  // steps, the engine's own choice
  static constexpr std::size_t most_arms =
      half_step::ContactHistory::arm_slots - (MaxwellArms::max_arms - Law::Arms::max_kernel_arms);

  Law in_steps(double h) const {
    if constexpr (std::same_as<Law, Fractional>) {
      const double coefficient = law_.coefficient() * std::pow(h, 2 - law_.alpha());
      return {coefficient, coefficient, law_.alpha()};
    } else {
      ParameterValues<Law> values = law_.values();
      for (std::size_t i = 0; i < values.size(); ++i) {
        const Dimension d = Law::parameters[i].dimension;
        values[i] *= std::pow(h, -(d.second + d.second_by_alpha * law_.alpha()) / 4);
      }
      return Law::from(values);
    }
  }

  const Law& law_;
  const Target& target_;
  MemoryKernel kernel_;
};

/// The error as a function of the steps.
std::function<double(double)> error_of(const AnyLaw& law, ContactEnd end, const Target& target, Stepping stepping) {
  if (stepping == Stepping::half_step)
    return [&law, &target, end](double steps) { return std::visit(Stepped{end, target, steps}, law); };
  if (!is_located(law, end))
    throw std::invalid_argument("contacts of laws with a memory that end by force are located, and no others");
  return std::visit(
      [&]<class Law>(const Law& one) -> std::function<double(double)> {
        if constexpr (RemembersAll<Law>) {
          const auto contact = std::make_shared<Located<Law>>(one, target);
          return [contact](double steps) { return contact->error(steps); };
        } else {
          return {};
        }
      },
      law);
}

void add_steps(std::vector<EngineStep>& all, std::string_view engine, const std::vector<StepError>& errors, double tcol,
               Stepping stepping) {
  for (const double bound : step_bounds) {
    const auto steps = steps_for(errors, bound, stepping);
    all.push_back({std::string(engine), bound, steps ? std::optional(tcol / *steps) : std::nullopt});
  }
}

}  // namespace

std::vector<Sensitivity> sensitivities(const AnyLaw& law, ContactEnd end, const Impact& impact) {
  constexpr double share = 1e-4;
  std::vector<Sensitivity> all;
  const auto of_law = parameters(law);
  for (std::size_t i = 0; i < of_law.size(); ++i) {
    Sensitivity s{of_law[i], {}, {}};
    const double p = of_law[i].value;
    const auto up = moved(law, i, p * (1 + share), end, impact), down = moved(law, i, p * (1 - share), end, impact);
    if (p != 0 && up && down) {
      const double step = std::log1p(share) - std::log1p(-share);
      s.tcol = std::log(up->tcol / down->tcol) / step;
      s.en = std::log(up->en / down->en) / step;
    }
    all.push_back(std::move(s));
  }
  return all;
}

std::vector<StepError> step_errors(const AnyLaw& law, ContactEnd end, const Target& target, Stepping stepping) {
  const auto error_at = error_of(law, end, target, stepping);
  constexpr auto decade = std::to_array({10, 12, 15, 20, 25, 30, 40, 50, 60, 80});
  constexpr double enough = *std::min_element(std::begin(step_bounds), std::end(step_bounds));
  std::vector<StepError> all;
  int within = 0;
  for (int tenths = 1; tenths <= 10000; tenths *= 10)
    for (const int digit : decade) {
      const int steps = tenths * digit / 10;
      if (steps < 5 || steps > 20000 || tenths * digit % 10 != 0) continue;
      const double error = error_at(steps);
      all.push_back({steps, error});
      within = error <= enough ? within + 1 : 0;
      if (within == 3) return all;
    }
  return all;
}

double step_error(const AnyLaw& law, ContactEnd end, const Target& target, double steps, Stepping stepping) {
  support::require_positive("steps", steps);
  return error_of(law, end, target, stepping)(steps);
}

Stepping stepping_of(const AnyLaw& law, ContactEnd end) {
  return is_located(law, end) ? Stepping::located : Stepping::half_step;
}

bool is_located(const AnyLaw& law, ContactEnd end) {
  return end == ContactEnd::force && std::visit([]<class Law>(const Law&) { return RemembersAll<Law>; }, law);
}

std::optional<int> steps_for(const std::vector<StepError>& errors, double bound, Stepping stepping) {
  std::optional<int> least;
  for (auto e = errors.rbegin(); e != errors.rend() && e->error <= bound; ++e) least = e->steps;
  if (least && stepping == Stepping::located) return std::max(*least, half_step::RunWatch::advised_steps);
  return least;
}

std::vector<EngineStep> engine_steps(const AnyLaw& law, ContactEnd end, const Target& target) {
  std::vector<EngineStep> all;
  const Stepping stepping = stepping_of(law, end);
  // Whether an engine has the law does not depend on the size of the grains.
  const ExportCase what{
      .law = law, .end = end, .tcol = target.tcol, .en = target.en, .impact = target.impact, .radius_eff = 1};
  std::vector<StepError> errors;  // alike in all that run it
  for (const Engine engine : engines()) {
    if (!runs(engine, what)) continue;
    if (errors.empty()) errors = step_errors(law, end, target, stepping);
    add_steps(all, stepping == Stepping::located ? driver(engine) : text(engine), errors, target.tcol, stepping);
  }
  return all;
}

std::vector<EngineStep> StepAdvisor::operator()(const AnyLaw& law, ContactEnd end, const Target& target) {
  const Held held = held_of(law);
  const auto [known, fresh] = known_.try_emplace({law.index(), end, target.en, held.alpha, held.stiffening});
  if (fresh) {
    known->second = engine_steps(law, end, target);
    for (EngineStep& s : known->second)
      if (s.step) s.step = std::round(target.tcol / *s.step);
  }
  std::vector<EngineStep> all = known->second;
  for (EngineStep& s : all)
    if (s.step) s.step = target.tcol / *s.step;
  return all;
}

double rayleigh_time(double radius, double density, double young, double poisson) {
  support::require_positive("radius", radius);
  support::require_positive("density", density);
  support::require_positive("young", young);
  support::require(poisson > -1 && poisson <= 0.5, "poisson", poisson, "in (-1, 0.5]");
  const double shear_modulus = young / (2 * (1 + poisson));
  return std::numbers::pi * radius * std::sqrt(density / shear_modulus) / (0.1631 * poisson + 0.8766);
}

std::optional<double> hertz_time_of(const AnyLaw& law, const Impact& impact) {
  if (const auto* l = std::get_if<KuwabaraKono>(&law)) return hertz_time(l->k(), impact);
  if (const auto* l = std::get_if<Tsuji>(&law)) return hertz_time(l->k(), impact);
  if (const auto* l = std::get_if<FractionalHertz>(&law); l && l->k() > 0) return hertz_time(l->k(), impact);
  return std::nullopt;
}

}  // namespace ricochet::calibration
