#pragma once

#include <console/json.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify {

/// One checked statement: `low <= value <= high`, open sides being infinite. A value that is not a number fails.
/// Bounds are derived or stated before the measurement; where a scheme has a stated order, both sides count, because
/// a scheme that beats its stated order is mislabelled.
struct Gate {
  std::string name;
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool pass = false;
};

Gate at_most(std::string name, double value, double bound);
Gate at_least(std::string name, double value, double bound);
Gate between(std::string name, double value, double low, double high);
/// |value - stated| <= tolerance.
Gate near(std::string name, double value, double stated, double tolerance);
/// A statement that is true or false; shown as 1 against 1.
Gate holds(std::string name, bool statement);

bool all_pass(const std::vector<Gate>& gates);

/// "<= 0.1", ">= 2", "in [1.9, 2.1]".
std::string bound_text(const Gate& gate);

/// How much of its room the value takes: 0 in the middle of two bounds or far inside one, 1 at a bound. Nothing where
/// the bounds name one value, or zero: there is no room to speak of.
std::optional<double> room_taken(const Gate& gate);

/// {"name", "value", "bound", "pass"}: `bound` is a number for one-sided gates, [low, high] for two-sided ones;
/// "kind" tells them apart: "at_most", "at_least", "between". A value that is not finite is null.
console::Json to_json(const Gate& gate);

/// The gates as a table; a value that is not finite shows as "-".
console::Table gate_table(const std::vector<Gate>& gates);

}  // namespace ricochet::verify
