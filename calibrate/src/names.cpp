#include <calibrate/calibration.hpp>

namespace ricochet::calibration {
namespace {

constexpr const char* stiffness_unit = "kg/s^2";
constexpr const char* damping_unit = "kg/s";
constexpr const char* hertzian_stiffness_unit = "kg/(s^2 m^(1/2))";

struct Parameters {
  std::vector<Parameter> operator()(const Linear& law) const {
    return {{"k", law.k(), stiffness_unit}, {"c", law.c(), damping_unit}};
  }
  std::vector<Parameter> operator()(const KuwabaraKono& law) const {
    return {{"k", law.k(), hertzian_stiffness_unit}, {"c", law.c(), "kg/(s m^(1/2))"}};
  }
  std::vector<Parameter> operator()(const Tsuji& law) const {
    return {{"k", law.k(), hertzian_stiffness_unit}, {"c", law.c(), "kg/(s m^(1/4))"}};
  }
  std::vector<Parameter> operator()(const Hysteretic& law) const {
    return {{"k1", law.k1(), stiffness_unit}, {"k2", law.k2(), stiffness_unit}};
  }
  std::vector<Parameter> operator()(const Fractional& law) const {
    return {{"k", law.k(), stiffness_unit}, {"c", law.c(), damping_unit}, {"alpha", law.alpha(), ""}};
  }
};

}  // namespace

std::string_view text(LawName law) noexcept {
  switch (law) {
    case LawName::linear: return Linear::name;
    case LawName::kuwabara_kono: return KuwabaraKono::name;
    case LawName::tsuji: return Tsuji::name;
    case LawName::hysteretic: return Hysteretic::name;
    case LawName::fractional: break;
  }
  return Fractional::name;
}

std::string_view text(ContactEnd end) noexcept { return end == ContactEnd::force ? "force" : "overlap"; }

std::string_view text(Method method) noexcept { return method == Method::nlopt ? "nlopt" : "direct"; }

std::vector<Parameter> parameters(const AnyLaw& law) { return std::visit(Parameters{}, law); }

std::vector<Parameter> identifiable(const AnyLaw& law) {
  const auto* fractional = std::get_if<Fractional>(&law);
  if (!fractional) return parameters(law);
  return {{"alpha", fractional->alpha(), ""}, {"c^alpha k^(1-alpha)", fractional->coefficient(), "kg s^(alpha-2)"}};
}

}  // namespace ricochet::calibration
