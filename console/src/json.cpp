#include <console/json.hpp>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace ricochet::console {

namespace {

void require_finite(const Json& json, const std::string& path) {
  if (json.is_number_float() && !std::isfinite(json.get<double>()))
    throw std::logic_error(fmt::format("JSON {} is not a finite number", path));
  if (json.is_object())
    for (const auto& [key, value] : json.items()) require_finite(value, fmt::format("{}/{}", path, key));
  if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i) require_finite(json[i], fmt::format("{}/{}", path, i));
}

struct AsJson {
  Json operator()(std::monostate) const { return nullptr; }
  template <class T>
  Json operator()(const T& value) const {
    return value;
  }
};

}  // namespace

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json rows_of(const Table& table) {
  Json rows = Json::array();
  for (const auto& cells : table.rows()) {
    Json row = Json::object();
    for (std::size_t i = 0; i < cells.size(); ++i) row[table.columns()[i].name] = std::visit(AsJson{}, cells[i]);
    rows.push_back(std::move(row));
  }
  return rows;
}

Json units_of(const Table& table) {
  Json units = Json::object();
  for (const Column& column : table.columns())
    if (!column.unit.empty()) units[column.name] = column.unit;
  return units;
}

std::string document(const Json& json) {
  require_finite(json, "");
  return json.dump(2) + "\n";
}

}  // namespace ricochet::console
