#include <calibrate/direct_calibrator.hpp>

#include "reduction_table.hpp"
#include "solution.hpp"

#include <ricochet/collision/fractional_contact_table.hpp>

#include <cmath>
#include <mutex>
#include <optional>
#include <tuple>

namespace ricochet::calibration {
namespace {

constexpr double least_en = FractionalContactTable::least_en;
constexpr double greatest_en = 0.9999;
static_assert(ReductionTable<Linear>::greatest_loss > 5.116, "the tables of every law reach down to least_en");

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

bool is_tabulated(double en) { return en == 1 || (en >= least_en && en <= greatest_en); }

/// A law in the units of the target as a function of e_n, for many targets; nullopt where the slow way has to be gone.
/// That is so for any law of which no more is known.
template <class Law>
struct Tabulated {
  std::optional<Law> operator()(double /*en*/, ContactEnd) { return std::nullopt; }
};

template <>
struct Tabulated<Hysteretic> {
  std::optional<Hysteretic> operator()(double en, ContactEnd end) {
    const auto unit = Reduction<Hysteretic>::unit(en, end);
    return unit ? std::optional(unit->law) : std::nullopt;
  }
};

template <class Form>
struct Tabulated<PowerLaw<Form>> {
  using Law = PowerLaw<Form>;
  Lazy<ReductionTable<Law>> by_force, by_overlap;

  std::optional<Law> operator()(double en, ContactEnd end) {
    if (en < least_en) return std::nullopt;
    const double loss = loss_of(en);
    if constexpr (std::same_as<Law, Linear>)
      if (end == ContactEnd::overlap) return Reduction<Law>::unit(en, end)->law;
    if (!is_tabulated(en)) return std::nullopt;
    const auto& table = (end == ContactEnd::force ? by_force : by_overlap)(end);
    if constexpr (std::same_as<Law, Linear>) return Law(table.stiffness(loss), 2 * loss);
    return Law(table.stiffness(loss), table.damping(loss));
  }
};

template <>
struct Tabulated<Fractional> {
  Lazy<FractionalContactTable> table;

  std::optional<Fractional> operator()(double en, ContactEnd end) {
    if (end == ContactEnd::overlap || !is_tabulated(en) || en == 1) return std::nullopt;
    const auto contact = table()(en);
    return Fractional(contact.z_star, contact.z_star, contact.alpha);
  }
};

template <class List>
struct TablesOf;
template <class... L>
struct TablesOf<LawList<L...>> {
  using type = std::tuple<Tabulated<L>...>;
};

}  // namespace

struct DirectCalibrator::Tables {
  TablesOf<Laws>::type of_law;

  /// nullopt where the tables do not reach, or a parameter is no normal double.
  std::optional<AnyLaw> operator()(const Request& request) {
    return request.law.visit([&]<class Law>(std::type_identity<Law>) -> std::optional<AnyLaw> {
      const auto unit = std::get<Tabulated<Law>>(of_law)(request.target.en, request.end);
      const auto law = unit ? in_si(*unit, request) : std::nullopt;
      return law ? std::optional<AnyLaw>(*law) : std::nullopt;
    });
  }

  template <class Law>
  std::optional<Law> in_si(const Law& unit, const Request& request) {
    return Reduction<Law>::in_si(unit, request.target.tcol, request.target.impact);
  }

  std::optional<Fractional> in_si(const Fractional& unit, const Request& request) {
    const auto& [tcol, en, impact] = request.target;
    const double held = request.stiffness ? *request.stiffness : held_of_linear(request.target);
    return Reduction<Fractional>::holding(held, unit, tcol, impact.mass_eff);
  }

  /// k of the linear law that hits the target by force, what the paper gives the fractional law to hold.
  double held_of_linear(const Target& target) {
    const auto unit = std::get<Tabulated<Linear>>(of_law)(target.en, ContactEnd::force);
    return unit->k() * target.impact.mass_eff / (target.tcol * target.tcol);
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
