#include <calibrate/advice.hpp>

#include <ricochet/fractional/memory_kernel.hpp>

#include <algorithm>
#include <cmath>
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
  return std::nan("");
}

template <ContactLaw Law>
double worst_error(const Law& law, ContactEnd end, const Target& target, int steps) {
  constexpr int places = 16;
  const double h = target.tcol / steps;
  double worst = 0;
  for (int place = 0; place < places; ++place) {
    const double en = stepped_restitution(law, end, target.impact, h, (place + 0.5) / places, 20 * steps);
    if (const double error = std::abs(en / target.en - 1); !(error <= worst)) worst = error;
  }
  return worst;
}

struct Stepped {
  ContactEnd end;
  const Target& target;
  int steps;

  template <class Law>
  double operator()(const Law& law) const {
    return worst_error(law, end, target, steps);
  }
  double operator()(const Fractional& law) const {
    const double h = target.tcol / steps;
    const MemoryWindow window{h, 10 * target.tcol, 1e-6};
    return worst_error(FractionalArms(law, affordable_kernel(law.alpha(), window, FractionalArms::max_arms), h), end,
                       target, steps);
  }
};

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

std::vector<StepError> step_errors(const AnyLaw& law, ContactEnd end, const Target& target) {
  std::vector<StepError> all;
  for (const int steps : {5, 7, 10, 15, 20, 30, 40, 50, 70, 100, 150, 200, 300, 500, 700, 1000})
    all.push_back({steps, std::visit(Stepped{end, target, steps}, law)});
  return all;
}

std::optional<int> steps_for(const std::vector<StepError>& errors, double bound) {
  std::optional<int> least;
  for (auto e = errors.rbegin(); e != errors.rend() && e->error <= bound; ++e) least = e->steps;
  return least;
}

}  // namespace ricochet::calibration
