#pragma once

#include <ricochet/contact/fractional.hpp>
#include <ricochet/contact/hysteretic.hpp>
#include <ricochet/contact/kuwabara_kono.hpp>
#include <ricochet/contact/linear.hpp>
#include <ricochet/contact/tsuji.hpp>

#include <variant>

namespace ricochet {

/// Any law of the model as its parameters: what calibration returns and scenes name. Visited once, at the edge.
using AnyLaw = std::variant<Linear, KuwabaraKono, Tsuji, Hysteretic, Fractional>;

std::string_view name(const AnyLaw& law) noexcept;

}  // namespace ricochet
