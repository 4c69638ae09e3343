#pragma once

#include <ricochet/contact/fractional.hpp>
#include <ricochet/contact/fractional_hertz.hpp>
#include <ricochet/contact/fractional_kelvin_voigt.hpp>
#include <ricochet/contact/fractional_zener.hpp>
#include <ricochet/contact/hysteretic.hpp>
#include <ricochet/contact/power_law.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace ricochet {

/// Laws by type: the variant of them, their names and what is asked of each follow from it.
template <DescribedLaw... L>
struct LawList {
  using Any = std::variant<L...>;
  static constexpr std::size_t size = sizeof...(L);
  static constexpr std::array<std::string_view, size> names{L::name...};
  static constexpr std::array<Ends, size> ends{L::ends...};
  static constexpr std::size_t most_parameters = std::max({L::parameters.size()...});

  /// The place of a law in the list; a law that is not in it does not compile.
  template <class Law>
  static constexpr std::size_t place = [] {
    static_assert((std::is_same_v<Law, L> + ...) == 1, "this law is not named in the list, or twice");
    std::size_t at = 0;
    (void)((std::is_same_v<Law, L> || (++at, false)) || ...);
    return at;
  }();

  /// f(std::type_identity<Law>) of the law at `place` < size.
  template <class F>
  static constexpr auto at(std::size_t place, const F& f) {
    return calls<F>[place](f);
  }

 private:
  template <class F>
  using ResultOf = std::common_type_t<std::invoke_result_t<const F&, std::type_identity<L>>...>;
  template <class F, class Law>
  static constexpr ResultOf<F> call(const F& f) {
    return f(std::type_identity<Law>{});
  }
  template <class F>
  static constexpr std::array<ResultOf<F> (*)(const F&), size> calls{&call<F, L>...};
};

/// The one list of laws. A new law is its header, its name here and its Reduction (collision/reduction.hpp); whatever
/// does not know it by heart then has it.
using Laws = LawList<Linear, KuwabaraKono, Tsuji, Hysteretic, Fractional, FractionalKelvinVoigt, FractionalHertz,
                     FractionalZener>;

/// Any law of the list as its parameters: what calibration returns and scenes name. Visited once, at the edge.
using AnyLaw = Laws::Any;

/// Which law of the list, without its parameters. No switch runs over it: what a law is, the law says.
class LawKind {
 public:
  /// Linear.
  constexpr LawKind() noexcept = default;
  template <class Law>
  static constexpr LawKind of() noexcept {
    return LawKind(Laws::place<Law>);
  }
  static LawKind of(const AnyLaw& law) noexcept { return LawKind(law.index()); }
  /// nullopt for a name that no law has.
  static std::optional<LawKind> named(std::string_view name) noexcept;
  /// All, in the order of the list.
  static std::array<LawKind, Laws::size> all() noexcept;

  constexpr std::size_t index() const noexcept { return index_; }
  constexpr bool operator==(const LawKind&) const noexcept = default;

  constexpr std::string_view name() const noexcept { return Laws::names[index_]; }
  std::span<const Parameter> parameters() const noexcept;
  constexpr Ends ends() const noexcept { return Laws::ends[index_]; }
  /// The law of that kind with these values of its parameters. Throws std::invalid_argument for another number of them
  /// and, naming it, for a value outside its domain.
  AnyLaw with(std::span<const double> values) const;

  /// f(std::type_identity<Law>) of the law's type.
  template <class F>
  constexpr auto visit(const F& f) const {
    return Laws::at(index_, f);
  }

 private:
  constexpr explicit LawKind(std::size_t index) noexcept : index_(index) {}
  std::size_t index_ = 0;
};

/// `kind_of<Linear>`, …
template <class Law>
inline constexpr LawKind kind_of = LawKind::of<Law>();

inline std::string_view name(const AnyLaw& law) noexcept { return LawKind::of(law).name(); }
std::vector<double> values(const AnyLaw& law);
/// The parameters of a law in their usual order.
std::vector<NamedValue> parameters(const AnyLaw& law);
/// What (tcol, en) determine: the parameters themselves, or the combinations that the law names instead.
std::vector<NamedValue> identifiable(const AnyLaw& law);

}  // namespace ricochet
