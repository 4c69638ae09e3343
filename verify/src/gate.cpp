#include <verify/gate.hpp>

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::verify {

namespace {

constexpr double open = std::numeric_limits<double>::infinity();

Gate make(std::string name, double value, double low, double high) {
  // Both comparisons are false for a NaN, on either side; an infinite value is never a pass.
  return {std::move(name), value, low, high, std::isfinite(value) && value >= low && value <= high};
}

}  // namespace

Gate at_most(std::string name, double value, double bound) { return make(std::move(name), value, -open, bound); }

Gate at_least(std::string name, double value, double bound) { return make(std::move(name), value, bound, open); }

Gate between(std::string name, double value, double low, double high) {
  return make(std::move(name), value, low, high);
}

Gate near(std::string name, double value, double stated, double tolerance) {
  return make(std::move(name), value, stated - tolerance, stated + tolerance);
}

Gate holds(std::string name, bool statement) { return make(std::move(name), statement ? 1 : 0, 1, 1); }

bool all_pass(const std::vector<Gate>& gates) {
  return std::all_of(gates.begin(), gates.end(), [](const Gate& gate) { return gate.pass; });
}

std::string bound_text(const Gate& gate) {
  const auto text = [](double value) { return console::significant(value, 6); };
  if (gate.low == -open) return fmt::format("<= {}", text(gate.high));
  if (gate.high == open) return fmt::format(">= {}", text(gate.low));
  if (gate.low == gate.high) return fmt::format("= {}", text(gate.low));
  return fmt::format("in [{}, {}]", text(gate.low), text(gate.high));
}

std::optional<double> room_taken(const Gate& gate) {
  if (!std::isfinite(gate.value) || gate.low == gate.high) return std::nullopt;
  if (gate.low == -open) return gate.high > 0 ? std::optional(std::max(0.0, gate.value / gate.high)) : std::nullopt;
  if (gate.high == open) return gate.low > 0 && gate.value > 0 ? std::optional(gate.low / gate.value) : std::nullopt;
  return std::abs(2 * gate.value - gate.low - gate.high) / (gate.high - gate.low);
}

console::Json to_json(const Gate& gate) {
  console::Json json{{"name", gate.name}, {"value", console::number_or_null(gate.value)}};
  if (gate.low == -open) {
    json["kind"] = "at_most";
    json["bound"] = console::number_or_null(gate.high);
  } else if (gate.high == open) {
    json["kind"] = "at_least";
    json["bound"] = console::number_or_null(gate.low);
  } else {
    json["kind"] = "between";
    json["bound"] = {console::number_or_null(gate.low), console::number_or_null(gate.high)};
  }
  json["pass"] = gate.pass;
  return json;
}

console::Table gate_table(const std::vector<Gate>& gates) {
  console::Table table({{"gate"}, {"value"}, {"bound"}, {"pass"}}, "Gates");
  for (const Gate& gate : gates)
    table.row(
        {gate.name, console::number_or_blank(gate.value), bound_text(gate), std::string(gate.pass ? "yes" : "NO")});
  return table;
}

}  // namespace ricochet::verify
