// What fits say beside one another, and of what kind each is.

#include <calibrate/fit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace ricochet::calibration {

std::string fit_name(const FitRequest& request) {
  return fmt::format("{}{}", request.law.name(), request.alpha_of_speed ? ", alpha(v)" : "");
}

std::vector<NamedValue> held(const FitRequest& request) {
  std::vector<NamedValue> values;
  if (request.law == kind_of<FractionalKelvinVoigt> || request.law == kind_of<FractionalZener>)
    values.push_back({"alpha", request.held.alpha, ""});
  if (request.law == kind_of<FractionalZener>) values.push_back({"k1/k", request.held.stiffening, ""});
  return values;
}

Preference preferred(const std::vector<Fit>& fits) {
  if (fits.empty()) throw std::invalid_argument("fits = 0: must be at least 1");
  std::vector<std::size_t> order(fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return fits[a].aic < fits[b].aic; });
  const double least = fits[order[0]].aic;
  const auto behind =
      std::find_if(order.begin(), order.end(), [&](std::size_t i) { return fits[i].aic > least + Preference::same; });
  Preference found{.best = {order.begin(), behind}};
  std::sort(found.best.begin(), found.best.end());
  if (behind == order.end()) return found;
  found.next = *behind;
  found.ahead = fits[*behind].aic - least;
  return found;
}

std::string preference_text(const std::vector<Fit>& fits) {
  if (fits.size() < 2) return "";
  const Preference found = preferred(fits);
  std::vector<std::string> names;
  for (const std::size_t place : found.best) names.push_back(fit_name(fits[place].request));
  const std::string best = fmt::format("{}", fmt::join(names, ", "));
  if (!found.next) return fmt::format("By the AIC none fits better than another of {}.", best);
  return fmt::format("By the AIC {} fit{} best; {:.1f} over {} comes {}.", best, names.size() == 1 ? "s" : "",
                     found.ahead, names.size() == 1 ? "it" : "them", fit_name(fits[*found.next].request));
}

}  // namespace ricochet::calibration
