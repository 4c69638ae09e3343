#include <ricochet/contact/laws.hpp>
#include <ricochet/support/require.hpp>

#include <algorithm>

namespace ricochet {

static_assert(ContactLaw<Linear> && ContactLaw<KuwabaraKono> && ContactLaw<Tsuji> && ContactLaw<Hysteretic>);

namespace {

/// "s^2", "m^(1/2)": a power, of quarters > 0.
std::string power_text(std::string_view unit, int quarters) {
  std::string text(unit);
  if (quarters % 4 == 0) return quarters == 4 ? text : text + "^" + std::to_string(quarters / 4);
  const int divisor = quarters % 2 == 0 ? 2 : 4;
  return text + "^(" + std::to_string(quarters * divisor / 4) + "/" + std::to_string(divisor) + ")";
}

}  // namespace

std::string unit_text(Dimension d) {
  std::string above, below;
  int factors_below = 0;
  if (d.second_by_alpha != 0) {  // of a springpot: kg s^(alpha-2), and what it has of metres
    const std::string rest = unit_text({0, d.metre, 0});
    above = "kg s^(alpha-" + std::to_string(-d.second / 4) + ")";
    return rest.starts_with("1") ? above + rest.substr(1) : above;
  }
  for (const auto& [unit, quarters] :
       {std::pair("kg", d.kilogram), std::pair("s", d.second), std::pair("m", d.metre)}) {
    if (quarters > 0) above += (above.empty() ? "" : " ") + power_text(unit, quarters);
    if (quarters < 0) below += (factors_below++ ? " " : "") + power_text(unit, -quarters);
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (factors_below > 1 ? "(" + below + ")" : below);
}

// In the units of an impact k and c are one number.
Fractional::Fractional(double k, double c, double alpha)
    : k_(k), c_(c), alpha_(alpha), coefficient_(c == k ? k : k * std::pow(c / k, alpha)) {
  require_parameters<Fractional>(values());
}

std::optional<LawKind> LawKind::named(std::string_view name) noexcept {
  for (const LawKind kind : all())
    if (kind.name() == name) return kind;
  return std::nullopt;
}

std::array<LawKind, Laws::size> LawKind::all() noexcept {
  std::array<LawKind, Laws::size> kinds;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = LawKind(i);
  return kinds;
}

std::span<const Parameter> LawKind::parameters() const noexcept {
  return visit([]<class Law>(std::type_identity<Law>) { return std::span<const Parameter>(Law::parameters); });
}

AnyLaw LawKind::with(std::span<const double> values) const {
  support::require(values.size() == parameters().size(), "number of parameters", static_cast<double>(values.size()),
                   "that of the law");
  return visit([&]<class Law>(std::type_identity<Law>) -> AnyLaw {
    ParameterValues<Law> own;
    std::copy(values.begin(), values.end(), own.begin());
    return Law::from(own);
  });
}

std::vector<double> values(const AnyLaw& law) {
  return std::visit(
      [](const auto& l) {
        const auto own = l.values();
        return std::vector<double>(own.begin(), own.end());
      },
      law);
}

namespace {

std::vector<NamedValue> named(std::span<const Parameter> parameters, std::span<const double> values) {
  std::vector<NamedValue> all;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    all.push_back({std::string(parameters[i].name), values[i], parameters[i].unit()});
  return all;
}

}  // namespace

std::vector<NamedValue> parameters(const AnyLaw& law) { return named(LawKind::of(law).parameters(), values(law)); }

std::vector<NamedValue> identifiable(const AnyLaw& law) {
  return std::visit(
      []<class Law>(const Law& l) {
        if constexpr (requires { l.identifiable(); })
          return l.identifiable();
        else
          return named(Law::parameters, l.values());
      },
      law);
}

}  // namespace ricochet
