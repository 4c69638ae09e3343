#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

/// Numbers with units, as people write them: "20us", "1 mm", "65GPa", "30deg", "1%". What a unit is worth is known here
/// alone, for flags and for the heads of CSV files. `si` names the unit in which the number is handed on: "s", "m",
/// "kg", "Pa", "m/s", "kg/m^3", "kg/s^2", "kg/s", "rad"; "" is a plain number, which may be a percentage. A number
/// without unit is in `si` already. `count_unit` is a plain number of which a percentage makes no sense.
inline constexpr std::string_view count_unit = "1";

/// The finite number that the whole of `text` spells, rounded once but for degrees; else nothing.
std::optional<double> parse_quantity(std::string_view text, std::string_view si);

/// Several: "0.1,0.2,0.5", or "0.3:0.9:0.1" from the first to the last in steps, the last included where a step meets
/// it; one number alone is a list of one. Units stand at every number or at none: "1,2,5us" could mean two things.
/// Throws std::invalid_argument saying what is accepted.
std::vector<double> parse_quantities(std::string_view text, std::string_view si);

/// "s, ms, us or ns": what `parse_quantity` knows.
std::string unit_choices(std::string_view si);

/// The power of ten from `unit` to `si`; nothing where it is none.
std::optional<int> decimal_exponent(std::string_view unit, std::string_view si);

}  // namespace ricochet::console
