#include <calibrate/known.hpp>

#include "reach.hpp"

#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace ricochet::calibration {
namespace {

double value_of(const Loss& loss) {
  struct Value {
    double operator()(const loss::Restitution& l) const { return l.en; }
    double operator()(const loss::LossFactor& l) const { return l.tan_delta; }
    double operator()(const loss::DampingRatio& l) const { return l.ratio; }
  };
  return std::visit(Value{}, loss);
}

/// The loss is more than the law can have and yet end so, or leaves no number of the velocity.
Infeasible lost(LawKind law, ContactEnd end, const Loss& loss) {
  const double limit = loss_limit(law, end, loss);
  const bool returns = value_of(loss) < limit;
  return {.law = law,
          .end = end,
          .reason = returns ? "so little of the velocity is left that no double carries the law"
                            : "from there on the overlap never returns to zero",
          .quantity = std::isfinite(limit) ? std::string(name(loss)) : "",
          .asked = value_of(loss),
          .lowest = 0,
          .highest = std::isfinite(limit) ? limit : 0};
}

void require_time(const Scale& scale, double tcol) {
  if (tcol >= least_scale && tcol <= greatest_scale) return;
  throw std::invalid_argument(fmt::format("{}: must be such that the collision time is {} s, not {}", name(scale),
                                          range_of_scales, support::shortest(tcol)));
}

}  // namespace

std::string_view name(const Scale& scale) noexcept {
  constexpr std::array<std::string_view, std::variant_size_v<Scale>> names{"tcol", "stiffness", "young", "max_overlap"};
  return names[scale.index()];
}

std::string_view name(const Loss& loss) noexcept {
  constexpr std::array<std::string_view, std::variant_size_v<Loss>> names{"en", "loss_factor", "damping_ratio"};
  return names[loss.index()];
}

std::variant<Request, Infeasible> request_of(LawKind law, ContactEnd end, const Known& known) {
  const auto en = restitution(law, end, known.loss);
  if (!en) return lost(law, end, known.loss);
  const auto tcol = collision_time(law, end, known.scale, *en, known.impact);
  if (!tcol) return out_of_reach({law, end, {1, *en, known.impact}}, Settings{}.tolerance);
  require_time(known.scale, *tcol);
  Request request{law, end, {*tcol, *en, known.impact}};
  if (law == kind_of<Fractional>) request.stiffness = stiffness(law, known.scale, known.impact);
  return request;
}

Outcome calibrate(LawKind law, ContactEnd end, const Known& known, const Settings& settings) {
  const auto request = request_of(law, end, known);
  if (const auto* missed = std::get_if<Infeasible>(&request)) return *missed;
  return calibrate(std::get<Request>(request), settings);
}

}  // namespace ricochet::calibration
