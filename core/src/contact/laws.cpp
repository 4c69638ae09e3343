#include <ricochet/contact/any_law.hpp>
#include <ricochet/support/require.hpp>

#include <array>

namespace ricochet {

using support::require;
using support::require_not_negative;
using support::require_positive;

static_assert(ContactLaw<Linear> && ContactLaw<KuwabaraKono> && ContactLaw<Tsuji> && ContactLaw<Hysteretic>);

Linear::Linear(double k, double c) : k_(k), c_(c) {
  require_positive("k", k);
  require_not_negative("c", c);
}

KuwabaraKono::KuwabaraKono(double k, double c) : k_(k), c_(c) {
  require_positive("k", k);
  require_not_negative("c", c);
}

Tsuji::Tsuji(double k, double c) : k_(k), c_(c) {
  require_positive("k", k);
  require_not_negative("c", c);
}

Hysteretic::Hysteretic(double k1, double k2) : k1_(k1), k2_(k2) {
  require_positive("k1", k1);
  require_positive("k2", k2);
  require(k1 <= k2, "k1", k1, "at most k2");
}

Fractional::Fractional(double k, double c, double alpha)
    : k_(k), c_(c), alpha_(alpha), coefficient_(k * std::pow(c / k, alpha)) {
  require_positive("k", k);
  require_positive("c", c);
  require(std::isfinite(alpha) && alpha < 2, "alpha", alpha, "finite and < 2");
}

namespace {

template <class... Laws>
std::string_view name_of(const std::variant<Laws...>& law) noexcept {
  constexpr std::array<std::string_view, sizeof...(Laws)> names{Laws::name...};
  return names[law.index()];
}

}  // namespace

std::string_view name(const AnyLaw& law) noexcept { return name_of(law); }

}  // namespace ricochet
