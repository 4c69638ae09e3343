#include <calibrate/direct_calibrator.hpp>

#include "reduction_table.hpp"
#include "solution.hpp"

#include <ricochet/collision/fractional_contact_table.hpp>

#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

namespace ricochet::calibration {
namespace {

constexpr double least_en = FractionalContactTable::least_en;
constexpr double greatest_en = 0.9999;
static_assert(ReductionTable<Linear>::greatest_loss > 5.116, "the tables of every law reach down to least_en");

/// A value that the first thread to need it makes. libstdc++'s call_once has no quick way past what is done.
template <class T>
class Lazy {
 public:
  template <class... Arguments>
  const T& operator()(Arguments... arguments) {
    if (!ready_.load(std::memory_order_acquire)) {
      std::call_once(made_, [&] {
        value_.emplace(arguments...);
        ready_.store(true, std::memory_order_release);
      });
    }
    return *value_;
  }

 private:
  std::once_flag made_;
  std::atomic<bool> ready_ = false;
  std::optional<T> value_;
};

/// The unit laws of real solids that were found, whose search takes milliseconds: rows of a file often share an e_n.
class KnownUnits {
 public:
  /// That of the request's law, end, e_n and what it holds; nothing where none is reached.
  std::optional<AnyLaw> operator()(const Request& request) {
    const Key key{request.law.index(), request.end, request.target.en, request.held.alpha, request.held.stiffening};
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = units_.find(key); known != units_.end()) return known->second;
    }
    Request unit = request;
    unit.target = {1, request.target.en, {1, 1}};
    const auto found = calibrate_directly(unit, Settings{}.tolerance);
    const auto* law = std::get_if<AnyLaw>(&found);
    if (!law) return std::nullopt;
    const std::lock_guard lock(mutex_);
    if (units_.size() < most) units_.emplace(key, *law);
    return *law;
  }

 private:
  static constexpr std::size_t most = 100'000;
  using Key = std::tuple<std::size_t, ContactEnd, double, double, double>;
  std::mutex mutex_;
  std::map<Key, AnyLaw> units_;
};

/// −ln e_n, and 0 (not −0) of 1.
double loss_of(double en) { return 0 - std::log(en); }

bool is_tabulated(double en) { return en == 1 || (en >= least_en && en <= greatest_en); }

/// A law's parameters in the units of the target as functions of e_n, for many targets; nullopt where the slow way has
/// to be gone. That is so for any law of which no more is known.
template <class Law>
struct Tabulated {
  std::optional<ParameterValues<Law>> operator()(double /*en*/, ContactEnd) { return std::nullopt; }
};

template <>
struct Tabulated<Hysteretic> {
  std::optional<ParameterValues<Hysteretic>> operator()(double en, ContactEnd) {
    return Reduction<Hysteretic>::unit_values(en);
  }
};

template <class Form>
struct Tabulated<PowerLaw<Form>> {
  using Law = PowerLaw<Form>;
  Lazy<ReductionTable<Law>> by_force, by_overlap;

  std::optional<ParameterValues<Law>> operator()(double en, ContactEnd end) {
    if (en < least_en) return std::nullopt;
    const double loss = loss_of(en);
    if constexpr (std::same_as<Law, Linear>)
      if (end == ContactEnd::overlap) return Reduction<Law>::values_by_overlap(loss);
    if (!is_tabulated(en)) return std::nullopt;
    const auto& table = (end == ContactEnd::force ? by_force : by_overlap)(end);
    if constexpr (std::same_as<Law, Linear>) return ParameterValues<Law>{table.stiffness(loss), 2 * loss};
    return table(loss);
  }
};

template <>
struct Tabulated<Fractional> {
  Lazy<FractionalContactTable> table;

  std::optional<ParameterValues<Fractional>> operator()(double en, ContactEnd end) {
    if (end == ContactEnd::overlap || !is_tabulated(en) || en == 1) return std::nullopt;
    const auto contact = table()(en);
    return ParameterValues<Fractional>{contact.z_star, contact.z_star, contact.alpha};
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
  KnownUnits units;

  /// By the table of the law; the slow way where it does not reach, or a parameter is no normal double.
  Answer operator()(const Request& request) {
    return request.law.visit([&]<class Law>(std::type_identity<Law>) -> Answer {
      if (const auto unit = std::get<Tabulated<Law>>(of_law)(request.target.en, request.end))
        if (const auto law = in_si<Law>(*unit, request)) return AnyLaw(*law);
      if constexpr (HoldsDegree<Law>)
        if (const auto unit = request.stiffness ? std::nullopt : units(request))
          if (const auto law = at_impact(*unit, request.target.tcol, request.target.impact)) return *law;
      return calibrate_directly(request, Settings{}.tolerance);
    });
  }

  template <class Law>
  std::optional<Law> in_si(const ParameterValues<Law>& unit, const Request& request) {
    const auto& [tcol, en, impact] = request.target;
    if constexpr (std::same_as<Law, Fractional>) {
      const double held = request.stiffness ? *request.stiffness : held_of_linear(request.target);
      return Reduction<Law>::holding(held, unit.front(), unit.back(), tcol, impact.mass_eff);
    } else {
      return representable<Law>(collision::values_in_si<Law>(unit, tcol, impact));
    }
  }

  /// k of the linear law that hits the target by force, what the paper gives the fractional law to hold.
  double held_of_linear(const Target& target) {
    const auto unit = std::get<Tabulated<Linear>>(of_law)(target.en, ContactEnd::force);
    return unit->front() * target.impact.mass_eff / (target.tcol * target.tcol);
  }
};

DirectCalibrator::DirectCalibrator() : tables_(std::make_unique<Tables>()) {}
DirectCalibrator::~DirectCalibrator() = default;

DirectCalibrator::Answer DirectCalibrator::operator()(const Request& request) const {
  require_request(request);
  return (*tables_)(request);
}

}  // namespace ricochet::calibration
