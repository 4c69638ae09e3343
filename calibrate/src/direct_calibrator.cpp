#include <calibrate/direct_calibrator.hpp>

#include "reduction_table.hpp"
#include "solution.hpp"

#include <ricochet/collision/fractional_contact_table.hpp>

#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

namespace ricochet::calibration {
namespace {

using std::numbers::pi;

constexpr double least_en = FractionalContactTable::least_en;
constexpr double greatest_en = 0.9999;
static_assert(ReductionTable::greatest_loss > 5.116, "the tables of every law reach down to least_en");

/// A value that the first thread to need it makes.
template <class T>
class Lazy {
 public:
  template <class... Arguments>
  const T& operator()(Arguments... arguments) {
    std::call_once(made_, [&] { value_.emplace(arguments...); });
    return *value_;
  }

 private:
  std::once_flag made_;
  std::optional<T> value_;
};

/// −ln e_n, and 0 (not −0) of 1.
double loss_of(double en) { return 0 - std::log(en); }

AnyLaw linear_by_overlap(const Target& t) {
  const double loss = loss_of(t.en), unit = t.impact.mass_eff / t.tcol;
  return Linear((pi * pi + loss * loss) * unit / t.tcol, 2 * loss * unit);
}

AnyLaw linear_by_force(const Target& t, const ReductionTable& table) {
  const double loss = loss_of(t.en), unit = t.impact.mass_eff / t.tcol;
  return Linear(table.stiffness(loss) * unit / t.tcol, 2 * loss * unit);
}

/// nullopt where k₂ is no normal double.
std::optional<AnyLaw> hysteretic(const Target& t) {
  const double root = 0.5 * pi * (1 + t.en) / t.tcol;
  const double k1 = root * root * t.impact.mass_eff, k2 = k1 / (t.en * t.en);
  if (!std::isnormal(k2)) return std::nullopt;
  return Hysteretic(k1, k2);
}

AnyLaw kuwabara_kono(const Target& t, const ReductionTable& table) {
  const double loss = loss_of(t.en);
  const double unit = t.impact.mass_eff / (std::sqrt(t.impact.velocity) * t.tcol * std::sqrt(t.tcol));
  return KuwabaraKono(table.stiffness(loss) * unit / t.tcol, table.damping(loss) * unit);
}

AnyLaw tsuji(const Target& t, const ReductionTable& table) {
  const double loss = loss_of(t.en);
  const double root = std::sqrt(t.impact.velocity * t.tcol);  // (v₀ t)^{1/2}
  const double unit = t.impact.mass_eff / t.tcol;
  return Tsuji(table.stiffness(loss) * unit / (root * t.tcol), table.damping(loss) * unit / std::sqrt(root));
}

}  // namespace

struct DirectCalibrator::Tables {
  Lazy<ReductionTable> linear, kuwabara_kono, tsuji_by_overlap, tsuji_by_force;
  Lazy<FractionalContactTable> fractional;

  const ReductionTable& linear_by_force() { return linear(LawName::linear, ContactEnd::force); }

  /// nullopt where the tables do not reach.
  std::optional<AnyLaw> fractional_law(const Request& request) {
    const Target& t = request.target;
    const double unit = t.impact.mass_eff / (t.tcol * t.tcol);
    const double held = request.stiffness ? *request.stiffness : linear_by_force().stiffness(loss_of(t.en)) * unit;
    if (t.en == 1 && !request.stiffness) return Fractional(held, std::sqrt(held * t.impact.mass_eff), 0);
    if (t.en == 1) return std::nullopt;
    const auto contact = fractional()(t.en);
    const double c = held * t.tcol * std::exp(std::log(contact.z_star * unit / held) / contact.alpha);
    if (!std::isnormal(c)) return std::nullopt;
    return Fractional(held, c, contact.alpha);
  }

  std::optional<AnyLaw> operator()(const Request& request) {
    const Target& t = request.target;
    const bool by_force = request.end == ContactEnd::force;
    if (request.law == LawName::hysteretic) return hysteretic(t);
    if (t.en < least_en) return std::nullopt;
    if (request.law == LawName::linear && !by_force) return linear_by_overlap(t);
    if (t.en > greatest_en && t.en < 1) return std::nullopt;
    switch (request.law) {
      case LawName::linear: return calibration::linear_by_force(t, linear_by_force());
      case LawName::kuwabara_kono:
        return calibration::kuwabara_kono(t, kuwabara_kono(LawName::kuwabara_kono, ContactEnd::force));
      case LawName::tsuji: return tsuji(t, (by_force ? tsuji_by_force : tsuji_by_overlap)(LawName::tsuji, request.end));
      case LawName::hysteretic:
      case LawName::fractional: break;
    }
    return by_force ? fractional_law(request) : std::nullopt;
  }
};

DirectCalibrator::DirectCalibrator() : tables_(std::make_unique<Tables>()) {}
DirectCalibrator::~DirectCalibrator() = default;

DirectCalibrator::Answer DirectCalibrator::operator()(const Request& request) const {
  require_request(request);
  if (const auto law = (*tables_)(request)) return *law;
  return calibrate_directly(request, Settings{}.tolerance);
}

}  // namespace ricochet::calibration
