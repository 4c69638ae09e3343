#include "../paper.hpp"
#include "drawings.hpp"
#include "panels.hpp"

#include <console/number.hpp>
#include <console/panels.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify::figures {

namespace {

using paper::pair, paper::table2;

template <class Law>
PrintedLaw printed(const std::string& name, const Law& law, ContactEnd end) {
  const Collision collision = collide(law, pair.impact, {.end = end});
  return {name, fmt::format("{}, ended by {}", Law::name, end == ContactEnd::overlap ? "overlap" : "force"), collision,
          trace(law, pair.impact, collision.tcol, 2000)};
}

}  // namespace

std::vector<PrintedLaw> table2_laws() {
  std::vector<PrintedLaw> laws;
  laws.push_back(printed("linear1", Linear(table2.linear1.k, table2.linear1.c), ContactEnd::overlap));
  laws.push_back(printed("linear2", Linear(table2.linear2.k, table2.linear2.c), ContactEnd::force));
  laws.push_back(printed("nonlinear", KuwabaraKono(table2.nonlinear.k, table2.nonlinear.c), ContactEnd::force));
  laws.push_back(printed("hysteretic", Hysteretic(table2.hysteretic.k1, table2.hysteretic.k2), ContactEnd::force));
  const Fractional law(table2.fractional.k, table2.fractional.c, table2.fractional.alpha);
  const Collision collision = collide(law, pair.impact);
  laws.push_back(
      {"fractional", "fractional, ended by force", collision, closed_form(law, pair.impact, collision.tcol)});
  return laws;
}

std::vector<const PrintedLaw*> by_end_overlap(const std::vector<PrintedLaw>& laws) {
  std::vector<const PrintedLaw*> sorted;
  sorted.reserve(laws.size());
  for (const PrintedLaw& law : laws) sorted.push_back(&law);
  std::stable_sort(sorted.begin(), sorted.end(), [](const PrintedLaw* a, const PrintedLaw* b) {
    return a->collision.overlap_end > b->collision.overlap_end;
  });
  return sorted;
}

console::Figure figure5(const std::vector<PrintedLaw>& laws) {
  std::vector<console::Motion> motions;
  for (const PrintedLaw& law : laws) {
    motions.push_back({law.title, {}});
    const std::size_t every = law.points.size() > 1000 ? 10 : 1;
    for (std::size_t i = 0; i < law.points.size(); i += every)
      motions.back().moments.push_back(
          {law.points[i].time, law.points[i].overlap, law.points[i].rate, law.points[i].force});
  }
  std::string order;
  for (const PrintedLaw* law : by_end_overlap(laws))
    order += fmt::format("{}{:.1f} µm for {}", order.empty() ? "" : ", ", 1e6 * law->collision.overlap_end, law->title);
  auto figure = console::collision_panels(
      "figure5",
      "Fig. 5: overlap, velocity and force under every law of Table II with the printed coefficients; kuwabara-kono is "
      "its nonlinear law.",
      motions);
  const double first = 1e6 * laws.front().collision.tcol;
  figure.finding = fmt::format(
      "All five laws bring the spheres from 0.5 to about {:.2f} m/s in about {} µs; they differ on the way, and in the "
      "overlap left at the end: {}.",
      laws.front().points.back().rate, console::significant(first, 3), order);
  return figure;
}

}  // namespace ricochet::verify::figures
