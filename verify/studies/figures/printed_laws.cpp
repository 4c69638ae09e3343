#include "../paper.hpp"
#include "drawings.hpp"
#include "panels.hpp"

#include <console/number.hpp>
#include <console/panels.hpp>

#include <fmt/format.h>

namespace ricochet::verify::figures {

namespace {

using paper::pair, paper::table2;

template <class Law>
PrintedLaw printed(const std::string& name, const Law& law, ContactEnd end) {
  const Collision collision = collide(law, pair.impact, {.end = end});
  return {name, collision, trace(law, pair.impact, collision.tcol, 2000)};
}

}  // namespace

std::vector<PrintedLaw> table2_laws() {
  std::vector<PrintedLaw> laws;
  laws.push_back(printed("linear1", Linear(table2.linear1.k, table2.linear1.c), ContactEnd::overlap));
  laws.push_back(printed("linear2", Linear(table2.linear2.k, table2.linear2.c), ContactEnd::force));
  laws.push_back(printed("nonlinear", KuwabaraKono(table2.nonlinear.k, table2.nonlinear.c), ContactEnd::force));
  laws.push_back(printed("hysteretic", Hysteretic(table2.hysteretic.k1, table2.hysteretic.k2), ContactEnd::force));
  const Fractional law(table2.fractional.k, table2.fractional.c, table2.fractional.alpha);
  const FractionalContact contact = fractional_contact(law.alpha());
  const FractionalTrajectory motion(law.coefficient(), law.alpha(), pair.impact.mass_eff, pair.impact.velocity);
  const double tcol = contact.tau * motion.time_scale();
  PrintedLaw fractional{"fractional", {}, closed_form(law, pair.impact, tcol)};
  fractional.collision.tcol = tcol;
  fractional.collision.en = contact.en;
  laws.push_back(fractional);
  return laws;
}

console::Figure figure5(const std::vector<PrintedLaw>& laws) {
  std::vector<console::Motion> motions;
  const PrintedLaw *deepest = &laws.front(), *shallowest = &laws.front();
  for (const PrintedLaw& law : laws) {
    motions.push_back({law.name, {}});
    const std::size_t every = law.points.size() > 1000 ? 10 : 1;
    for (std::size_t i = 0; i < law.points.size(); i += every)
      motions.back().moments.push_back(
          {law.points[i].time, law.points[i].overlap, law.points[i].rate, law.points[i].force});
    if (law.points.back().overlap > deepest->points.back().overlap) deepest = &law;
    if (law.points.back().overlap < shallowest->points.back().overlap) shallowest = &law;
  }
  auto figure = console::collision_panels(
      "figure5", "Fig. 5: overlap, velocity and force under every law of Table II with the printed coefficients.",
      motions);
  const double first = 1e6 * laws.front().collision.tcol;
  figure.finding = fmt::format(
      "All five laws bring the spheres from 0.5 to about {:.2f} m/s in about {} µs; they differ on the way, and in the "
      "overlap left at the end: {:.1f} µm for {}, {:.1f} µm for {}.",
      laws.front().points.back().rate, console::significant(first, 3), 1e6 * shallowest->points.back().overlap,
      shallowest->name, 1e6 * deepest->points.back().overlap, deepest->name);
  return figure;
}

}  // namespace ricochet::verify::figures
