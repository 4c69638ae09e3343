#pragma once

#include <ricochet/contact/law.hpp>
#include <ricochet/support/require.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace ricochet {

/// The numbers that a parameter may take, and how that is said: "k = -1: must be finite and > 0".
struct Domain {
  std::string_view accepted;
  bool (*contains)(double value);
};

namespace domains {
inline constexpr Domain positive{"finite and > 0", [](double x) { return std::isfinite(x) && x > 0; }};
inline constexpr Domain not_negative{"finite and >= 0", [](double x) { return std::isfinite(x) && x >= 0; }};
inline constexpr Domain degree{"in [0, 1]", [](double x) { return x >= 0 && x <= 1; }};
}  // namespace domains

/// kg^a m^b s^(c + dα), the exponents in quarters: {4, -2, -8} is kg/(s^2 m^(1/2)), {4, 0, -8, 4} kg s^(alpha-2).
struct Dimension {
  int kilogram = 0, metre = 0, second = 0;
  int second_by_alpha = 0;  ///< 0 but for a springpot's coefficient
};

/// "kg/(s^2 m^(1/2))"; "" for a plain number.
std::string unit_text(Dimension dimension);

/// A parameter of a law: its published name, what it measures and the values it may take.
struct Parameter {
  std::string_view name;
  Dimension dimension;
  Domain domain;

  std::string unit() const { return unit_text(dimension); }
};

/// A number with its name and unit.
struct NamedValue {
  std::string name;
  double value;
  std::string unit;
};

/// The ends that a law is calibrated for, and whether both are meant where nobody says.
struct Ends {
  bool overlap;  ///< (24); ended by force (25) every law is
  bool both_by_default;

  constexpr bool offer(ContactEnd end) const noexcept { return end == ContactEnd::force || overlap; }
};

/// A law that says once what it is, so that names, readers, tables, files and reports follow from it:
///
/// - `name`: the word for it on command lines and in files;
/// - `parameters`: in their usual order, each with name, dimension and domain. The first is a stiffness (it sets the
///   collision time), the second what loses energy, for whom nothing else is said (see Reduction);
/// - `ends`: see Ends;
/// - `values()`: the parameters' values in that order; `from(values)`: the law of these values, which throws
///   std::invalid_argument "name = value: must be …" for one outside its domain.
///
/// A law of which a collision shows only combinations of its parameters names them by `identifiable()`.
template <class Law>
concept DescribedLaw = std::copyable<Law> && requires(const Law& law) {
  { Law::name } -> std::convertible_to<std::string_view>;
  {std::span<const Parameter>(Law::parameters)};
  { Law::ends } -> std::convertible_to<Ends>;
  { law.values() } -> std::same_as<std::array<double, Law::parameters.size()>>;
  { Law::from(law.values()) } -> std::same_as<Law>;
};

/// The values of a law's parameters.
template <class Law>
using ParameterValues = std::array<double, Law::parameters.size()>;

/// Throws std::invalid_argument naming the first value outside its domain. Which domain each has is known where this is
/// compiled, so that a law costs no more than its comparisons.
template <class Law>
void require_parameters(const ParameterValues<Law>& values) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (support::require(Law::parameters[I].domain.contains(values[I]), Law::parameters[I].name, values[I],
                      Law::parameters[I].domain.accepted),
     ...);
  }
  (std::make_index_sequence<Law::parameters.size()>{});
}

/// The law of these values, or nothing where one of them is no number that a double carries with all its digits:
/// neither normal nor a 0 that its domain admits.
template <DescribedLaw Law>
std::optional<Law> representable(const ParameterValues<Law>& values) {
  bool all = true;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((all = all && (std::isnormal(values[I]) || (values[I] == 0 && Law::parameters[I].domain.contains(0)))), ...);
  }
  (std::make_index_sequence<Law::parameters.size()>{});
  return all ? std::optional<Law>(Law::from(values)) : std::nullopt;
}

}  // namespace ricochet
