#pragma once

#include <console/table.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace ricochet::console {

/// JSON whose keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

/// `value` as JSON number, or null where it is not finite: the explicit choice of a caller who has an "unknown".
Json number_or_null(double value);

/// One object a row, keyed by the columns' names.
Json rows_of(const Table& table);

/// {"name": "unit", …} of the columns that have a unit.
Json units_of(const Table& table);

/// The document as text with full double precision, indented, ending in a newline. Throws std::logic_error naming
/// the path of the first number that is not finite (the JSON library alone would write null without a word).
std::string document(const Json& json);

}  // namespace ricochet::console
