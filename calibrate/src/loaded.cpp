#include <calibrate/loaded.hpp>

#include "solution.hpp"

#include <ricochet/collision/loaded.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::calibration {
namespace {

constexpr double accuracy = 1e-8;

/// Not parting is taking too long.
constexpr double never = 1e3;

/// Collisions that the roots may ask for; some hundred are enough where there are any.
constexpr std::size_t most_collisions = 400;

/// A law in the units of the target under the load in those units.
class Loaded {
 public:
  Loaded(const Request& request, double load) : request_(request), load_(load) {}

  /// The collision of that loss whose stiffness makes it take 1; none where no stiffness does.
  Collision at(double loss) {
    const auto late = [&](double scale) {
      if (++evaluations_ > most_collisions) return never;
      const Collision out = unit_collision(request_, {scale, loss}, load_);
      return out.separated() ? std::log(out.tcol) : never;
    };
    double low = scale_, high = scale_, at_low = late(scale_), at_high = at_low;
    if (evaluations_ > most_collisions) return {};
    constexpr double farthest = 15;
    for (double step = 0.5; at_low <= 0 && scale_ - low < farthest; step *= 1.6) {
      high = low, at_high = at_low;
      low -= step, at_low = late(low);
    }
    for (double step = 0.5; at_high > 0 && high - scale_ < farthest; step *= 1.6) {
      low = high, at_low = at_high;
      high += step, at_high = late(high);
    }
    if (!(at_low > 0 && at_high <= 0)) return {};
    const double scale = support::root_bracket(late, low, high, at_low, at_high, {.relative = 1e-13}).second;
    const Collision out = unit_collision(request_, {scale, loss}, load_);
    if (!out.separated() || std::abs(out.tcol - 1) > accuracy) return {};
    scale_ = scale;
    return out;
  }

  AnyLaw law_at(double loss) const { return scaled_law(request_.law, {scale_, loss}, request_.held); }
  std::size_t evaluations() const { return evaluations_; }

 private:
  const Request& request_;
  double load_;
  double scale_ = 2;  // of the last answer: ln π², about
  std::size_t evaluations_ = 0;
};

std::optional<Solution> by_roots(const Request& request, double load) {
  const double en = request.target.en;
  Loaded loaded(request, load);
  double loss = -std::numeric_limits<double>::infinity();
  if (en < 1) {
    const auto found = collision::find_loss([&](double x) { return loaded.at(x); }, en);
    if (!found) return std::nullopt;
    loss = found->loss;
  }
  if (!loaded.at(loss).separated()) return std::nullopt;
  return Solution{loaded.law_at(loss), "bracketed roots", loaded.evaluations()};
}

double difference(const AnyLaw& a, const AnyLaw& b) {
  const auto ours = identifiable(a), theirs = identifiable(b);
  double greatest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (const double size = std::max(std::abs(ours[i].value), std::abs(theirs[i].value)); size > 0)
      greatest = std::max(greatest, std::abs(ours[i].value - theirs[i].value) / size);
  return greatest;
}

Calibration answered(const Request& request, const AnyLaw& law, double load) {
  const Impact& impact = request.target.impact;
  Calibration out{.request = request,
                  .law = law,
                  .end = ContactEnd::force,
                  .achieved = collide_under_load(law, impact, load),
                  .tcol_residual = 0,
                  .en_residual = 0,
                  .tcol_estimate = {},
                  .method = Method::direct,
                  .algorithm = "collision under a load",
                  .evaluations = 1,
                  .cross_method = Method::direct,
                  .cross_difference = 0};
  out.under_load = UnderLoad{load, least_speed_to_part(law, impact.mass_eff, load), clears(out.achieved, impact, load)};
  return out;
}

}  // namespace

Outcome answer_under_load(const AnyLaw& law, const Impact& impact, double load) {
  const LawKind kind = LawKind::of(law);
  require_request({kind, ContactEnd::force, {1, 1, impact}});
  support::require_positive("load", load);
  const Collision out = collide_under_load(law, impact, load);
  if (out.status == CollisionStatus::budget_spent)
    throw NotConverged(fmt::format("{} under a load: the collision does not come to an end", kind.name()));
  if (!out.separated()) {
    const double least = least_speed_to_part(law, impact.mass_eff, load);
    const std::string reason = std::isfinite(least) ? "below, the load keeps the bodies together and there is no en"
                                                    : "the load keeps the bodies together at any speed";
    if (!std::isfinite(least)) return Infeasible{kind, ContactEnd::force, reason, "", 0, 0, 0};
    return Infeasible{kind, ContactEnd::force, reason, "velocity", impact.velocity, least, greatest_scale};
  }
  Calibration answer = answered({kind, ContactEnd::force, {out.tcol, out.en, impact}}, law, load);
  if (const auto* fractional = std::get_if<Fractional>(&law)) answer.request.stiffness = fractional->k();
  return answer;
}

Outcome calibrate_under_load(const Request& request, double load, const Settings& settings) {
  require_request(request);
  support::require_positive("load", load);
  const auto& [tcol, en, impact] = request.target;
  const double scaled = load * tcol / (impact.mass_eff * impact.velocity);
  const auto direct = by_roots(request, scaled);
  const auto law = direct ? brought_to(direct->law, request) : std::nullopt;
  if (!law)
    return Infeasible{
        request.law,
        ContactEnd::force,
        fmt::format("under a load of {} m v/tcol no contact of this law takes so long and parts with that en",
                    support::significant(scaled, 3)),
        "",
        0,
        0,
        0};
  const Solution found = search(request, settings.algorithm, std::max(settings.tolerance, accuracy), scaled);
  Calibration out = answered(request, *law, load);
  out.cross_difference = difference(direct->law, found.law);
  const bool agrees = out.cross_difference <= 1e-5;
  const auto searched = settings.method == Method::nlopt && agrees ? brought_to(found.law, request) : std::nullopt;
  if (searched) {
    out.law = *searched;
    out.achieved = collide_under_load(out.law, impact, load);
  }
  out.method = searched ? Method::nlopt : Method::direct;
  out.cross_method = searched ? Method::direct : Method::nlopt;
  out.algorithm = searched ? found.algorithm : direct->algorithm;
  out.evaluations = searched ? found.evaluations : direct->evaluations;
  if (!agrees)
    out.remarks.push_back(fmt::format("{} missed the tolerance; the direct solution is answered", found.algorithm));
  out.tcol_residual = out.achieved.tcol / tcol - 1;
  out.en_residual = out.achieved.en / en - 1;
  if (!(std::max(std::abs(out.tcol_residual), std::abs(out.en_residual)) <= 1e-5))
    throw NotConverged(
        fmt::format("{} under a load: the collision misses the target by {}", request.law.name(),
                    support::significant(std::max(std::abs(out.tcol_residual), std::abs(out.en_residual)), 2)));
  return out;
}

}  // namespace ricochet::calibration
