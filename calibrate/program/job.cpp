#include "job.hpp"

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::shortest;

constexpr double default_velocity = 0.5;
constexpr double default_mass_eff = 7.06858e-6;
constexpr double default_radius_eff = 0.75e-3, default_density = 1000;

double positive(const char* flag, double value) {
  if (!(value > 0)) throw BadInput(flag, shortest(value), "> 0");
  if (!(value >= least_scale && value <= greatest_scale)) throw BadInput(flag, shortest(value), range_of_scales);
  return value;
}

/// The positive value of an option that must have been given.
double needed(const char* flag, const std::optional<double>& value, const char* what) {
  if (!value) throw BadInput(fmt::format("{}: missing: must be given, {}", flag, what));
  return positive(flag, *value);
}

void refuse_with(const char* flag, const std::optional<double>& value, bool given, const char* companion) {
  if (value && given) throw BadInput(flag, shortest(*value), fmt::format("left out with {}", companion));
}

double sphere_mass(double radius, double density) {
  return 4 * std::numbers::pi / 3 * radius * radius * radius * density;
}

bool speaks_of_spheres(const Options& o) { return o.radius || o.density || o.radius2 || o.density2 || o.wall; }

double usable_mass(double mass) {
  if (!(mass >= least_scale && mass <= greatest_scale))
    throw BadInput("--radius and --density: effective mass", shortest(mass) + " kg", range_of_scales);
  return mass;
}

/// m₁m₂/(m₁+m₂), or the sphere's mass against a wall.
double mass_of_spheres(const Options& o, Job& job) {
  const double radius =
      needed("--radius", o.radius, "a radius [m], > 0, with --density, --radius2, --density2 or --wall");
  const double density = needed("--density", o.density, "a density [kg/m^3], > 0, with --radius");
  const double mass = sphere_mass(radius, density);
  job.radius = radius;
  job.radius_eff = radius;
  job.density = density;
  job.wall = o.wall;
  if (o.wall) {
    refuse_with("--radius2", o.radius2, true, "--wall");
    refuse_with("--density2", o.density2, true, "--wall");
    return mass;
  }
  if (!o.radius2 && !o.density2) job.assumptions.push_back("two equal spheres (--radius2, --density2, --wall)");
  const double radius2 = positive("--radius2", o.radius2.value_or(radius));
  const double other = sphere_mass(radius2, positive("--density2", o.density2.value_or(density)));
  job.radius = std::min(radius, radius2);
  job.radius_eff = radius / (1 + radius / radius2);
  if (o.density2.value_or(density) != density) job.density.reset();
  return mass / (1 + mass / other);
}

double mass_eff(const Options& o, Job& job) {
  if (o.mass_eff) {
    positive("--mass-eff", *o.mass_eff);
    if (speaks_of_spheres(o))
      throw BadInput("--mass-eff", shortest(*o.mass_eff), "left out with --radius, --density or --wall");
    return *o.mass_eff;
  }
  if (speaks_of_spheres(o)) return usable_mass(mass_of_spheres(o, job));
  job.assumptions.push_back(fmt::format(
      "effective mass {} kg, two spheres of radius 1.5 mm and 1000 kg/m^3 (--mass-eff)", shortest(default_mass_eff)));
  job.radius_eff = default_radius_eff;
  job.density = default_density;
  return default_mass_eff;
}

Target target_of(const Options& o, Job& job) {
  const double tcol = needed("--tcol", o.tcol, "a collision time [s], > 0");
  if (!o.en) throw BadInput("--en: missing: must be given, a restitution in (0, 1]");
  if (!(*o.en > 0 && *o.en <= 1)) throw BadInput("--en", shortest(*o.en), "in (0, 1]");
  if (!o.velocity)
    job.assumptions.push_back(fmt::format("impact velocity {} m/s (--velocity)", shortest(default_velocity)));
  const double velocity = positive("--velocity", o.velocity.value_or(default_velocity));
  return {tcol, *o.en, {velocity, mass_eff(o, job)}};
}

std::vector<LawKind> laws_of(const Options& o) {
  if (const auto all = LawKind::all(); o.law == "all") return {all.begin(), all.end()};
  return {law_named("--law", o.law)};
}

/// The asked ends that `law` offers.
std::vector<ContactEnd> ends_of(const Options& o, LawKind law) {
  const bool both = o.end == "both" || (o.end.empty() && law.ends().both_by_default);
  std::vector<ContactEnd> ends;
  for (const auto end : {ContactEnd::overlap, ContactEnd::force}) {
    const bool asked = both || (o.end.empty() ? end == ContactEnd::force : text(end) == o.end);
    if (asked && law.ends().offer(end)) ends.push_back(end);
  }
  return ends;
}

}  // namespace

std::string law_names() {
  const std::span all(Laws::names);
  return fmt::format("{} or {}", fmt::join(all.first(all.size() - 1), ", "), all.back());
}

LawKind law_named(std::string_view flag, std::string_view name) {
  const auto law = LawKind::named(name);
  if (!law) throw BadInput(flag, console::excerpt(name), law_names());
  return *law;
}

ContactEnd end_named(std::string_view flag, std::string_view name) {
  if (name == text(ContactEnd::force)) return ContactEnd::force;
  if (name == text(ContactEnd::overlap)) return ContactEnd::overlap;
  throw BadInput(flag, console::excerpt(name), "overlap or force");
}

void take_only(const Options& options, std::string_view mode, std::initializer_list<std::string_view> accepted) {
  for (const std::string& name : options.given)
    if (std::find(accepted.begin(), accepted.end(), name) == accepted.end())
      throw BadInput(fmt::format("{}: must be left out with {}", name, mode));
}

TargetDefaults target_defaults(const Options& o) {
  TargetDefaults defaults;
  Job job;
  if (!o.law.empty()) defaults.law = law_named("--law", o.law);
  if (!o.end.empty()) defaults.end = end_named("--end", o.end);
  defaults.impact = {positive("--velocity", o.velocity.value_or(default_velocity)), mass_eff(o, job)};
  defaults.assumptions = job.assumptions;
  if (o.stiffness) defaults.stiffness = positive("--stiffness", *o.stiffness);
  return defaults;
}

Job job_of(const Options& o) {
  Job job;
  job.target = target_of(o, job);
  if (o.stiffness) positive("--stiffness", *o.stiffness);
  if (o.stiffness && o.law != "all" && o.law != "fractional")
    throw BadInput("--stiffness", shortest(*o.stiffness),
                   fmt::format("left out with --law {}; only fractional holds a k", o.law));
  for (const auto law : laws_of(o)) {
    const auto ends = ends_of(o, law);
    if (ends.empty() && o.law != "all") throw BadInput("--end", o.end, "force with --law " + o.law);
    if (ends.empty()) job.left_out.push_back(law);
    for (const auto end : ends) job.requests.push_back({law, end, job.target, o.stiffness});
  }
  if (!o.stiffness && std::any_of(job.requests.begin(), job.requests.end(),
                                  [](const Request& r) { return r.law == kind_of<Fractional>; }))
    job.assumptions.push_back("the fractional law holds the k of the linear law ended by force (--stiffness)");
  return job;
}

}  // namespace ricochet::calibration
