#include "fit_run.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::calibration {
namespace {

using console::shortest;

/// The middle one of the measured speeds.
double usual_velocity(const std::vector<Measurement>& data) {
  std::vector<double> all;
  all.reserve(data.size());
  for (const Measurement& m : data) all.push_back(m.velocity);
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

/// The bodies of the first row, where rows have theirs, as flags would say them.
void take_bodies(Asked& asked, const Measurement& first) {
  if (!(first.mass_eff > 0)) return;
  asked.density.reset();
  if (!(first.radius_eff > 0)) {
    asked.mass_eff = first.mass_eff;
    asked.wall = false;
    return;
  }
  const double share = asked.wall ? 1 : 0.5, radius = first.radius_eff / share;
  asked.radius = radius;
  asked.density = first.mass_eff / share / sphere_mass(radius, 1);
}

Infeasible not_to_be_run(const Fit& fit, double velocity, double en) {
  const double alpha = conversion_degree(en, fit.request.end);
  return {.law = fit.request.law,
          .end = fit.request.end,
          .reason = fmt::format("alpha follows the speed, which no engine and no run here takes; at {} m/s it is {}: "
                                "--law fractional --alpha {}",
                                shortest(velocity), console::significant(alpha, 4), console::significant(alpha, 4)),
          .quantity = ""};
}

/// What one collision leaves open of the law: as it is fitted, or as it was held.
void take_held(Asked& asked, const Fit& fit) {
  asked.alpha.reset();
  asked.stiffening.reset();
  if (!holds_degree(fit.request.law)) return;
  asked.alpha = fit.request.held.alpha;
  for (const Estimate& p : fit.parameters)
    if (p.name == "alpha") asked.alpha = p.value;
  if (fit.request.law == kind_of<FractionalZener>) asked.stiffening = fit.request.held.stiffening;
}

void add(Report& report, const Fit& fit, Asked asked, bool times) {
  const double velocity = *asked.velocity;
  const Prediction p = predict(fit, velocity);
  if (fit.request.alpha_of_speed) {
    report.infeasible.push_back(not_to_be_run(fit, velocity, p.en));
    return;
  }
  asked.en = std::min(p.en, 1.0);
  take_held(asked, fit);
  if (times) asked.tcol = p.tcol;
  const Reading reading = read(asked, Spelling::flags);
  if (!fits(reading.spring, fit.request.law)) {
    report.infeasible.push_back(
        {.law = fit.request.law,
         .end = fit.request.end,
         .reason = fmt::format("--stiffness = {}: must be {}", stated(*asked.stiffness, reading.spring),
                               spring_of(fit.request.law)),
         .quantity = ""});
    return;
  }
  Job job = report.job;
  job.known = reading.known;
  job.wanted = {{fit.request.law, fit.request.end}};
  const Report one = run(job, {});
  report.results.insert(report.results.end(), one.results.begin(), one.results.end());
  report.infeasible.insert(report.infeasible.end(), one.infeasible.begin(), one.infeasible.end());
  report.failed.insert(report.failed.end(), one.failed.begin(), one.failed.end());
  report.job.known = reading.known;
  report.job.radius_eff = reading.bodies.radius_eff;
  report.job.density = reading.bodies.density;
  if (reading.bodies.from_radii) report.job.radius = reading.bodies.smaller_radius;
}

}  // namespace

std::optional<Report> run_of_fits(const Options& options, const std::vector<Fit>& fits,
                                  const std::vector<Measurement>& data) {
  const bool times = data.front().tcol > 0;
  Asked asked = options.asked;
  if (times && speaks_of(asked, Topic::scale))
    throw console::BadInput(
        "--fit: a scale (--tcol, --stiffness, …): must be left out with data that have collision times");
  if (!times && !speaks_of(asked, Topic::scale)) return std::nullopt;
  take_bodies(asked, data.front());
  Report report{};
  report.job.wall = asked.wall;
  if (!asked.velocity) {
    asked.velocity = usual_velocity(data);
    report.job.assumptions.push_back(
        fmt::format("impact velocity {} m/s, the middle one of the data (--velocity)", shortest(*asked.velocity)));
  }
  report.job.title = fmt::format("the fits of {}", options.fit == "-" ? "standard input" : options.fit);
  for (const Fit& fit : fits) add(report, fit, asked, times);
  if (fits.size() == 1 && !calibration::fits(asked.spring, fits.front().request.law))
    throw console::BadInput(report.infeasible.front().reason);
  return report;
}

}  // namespace ricochet::calibration
