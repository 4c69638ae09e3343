#include "collisions.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace engines::collisions {

namespace {

// As fractions of a step.
const std::vector<double> phases{0.03, 0.25, 0.5, 0.75, 0.97};

// Time from the touch (known: the approach is free) to the zero of the force. The engine only has max(0, R), and its
// last two positive values may carry the end of the ramp: the zero is where the cubic through the four before ends.
double contact_time(const std::vector<Frame>& frames, std::size_t grain, double phase, double dt) {
  std::vector<double> force;
  for (const Frame& frame : frames) force.push_back(std::fabs(frame.force[grain][0]));
  const auto first = std::find_if(force.begin(), force.end(), [](double f) { return f > 0; });
  const auto end = std::find(first, force.end(), 0.0);
  const auto last = end - 3;
  const double d1 = last[0] - last[-1], d2 = d1 - (last[-1] - last[-2]), d3 = d2 - (last[-1] - 2 * last[-2] + last[-3]);
  const auto cubic = [&](double s) { return last[0] + s * d1 + s * (s + 1) / 2 * d2 + s * (s + 1) * (s + 2) / 6 * d3; };
  double low = 0, high = 5;  // steps after the last value
  for (int i = 0; i < 60; ++i) (cubic((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return (static_cast<double>(last - force.begin()) + low - 3 - phase) * dt;
}

}  // namespace

std::vector<Grain> grains(std::size_t materials, double dt, bool wall) {
  std::vector<Grain> all;
  for (std::size_t m = 0; m < materials; ++m)
    for (std::size_t p = 0; p < phases.size(); ++p) {
      const double gap = (3 + phases[p]) * speed * dt;
      Grain a{.type = static_cast<int>(m + 1), .radius = 1e-3 + 2e-4 * p, .density = 1000 + 500. * m};
      Grain b = a;
      const double y = 0.005 * (m + 1), z = 0.005 * (p + 1);
      b.radius = 1.5e-3;
      a.position = {wall ? a.radius + gap : 0.01, y, z};
      b.position = {0.01 + a.radius + b.radius + gap, y, z};
      a.velocity = {wall ? -speed : speed / 2, 0, 0};
      b.velocity = {-speed / 2, 0, 0};
      all.push_back(a);
      if (!wall) all.push_back(b);
    }
  return all;
}

Box box(std::size_t materials, bool wall) {
  return {{wall ? -0.001 : 0, 0, 0}, {0.02, 0.03, 0.03}, "f f f", static_cast<int>(materials)};
}

int steps_of_run(int steps_per_contact) { return steps_per_contact + steps_per_contact / 5 + 10; }

void add_run(std::vector<Errors>& errors, const std::vector<Frame>& frames, const std::vector<double>& restitutions,
             double dt, bool wall) {
  errors.resize(restitutions.size());
  for (std::size_t m = 0; m < restitutions.size(); ++m) {
    double worst_time = 0, worst_en = 0;
    for (std::size_t p = 0; p < phases.size(); ++p) {
      const std::size_t i = (m * phases.size() + p) * (wall ? 1 : 2);
      const auto& v = frames.back().velocity;
      const double en = (wall ? v[i][0] : v[i + 1][0] - v[i][0]) / speed;
      worst_en = std::max(worst_en, std::fabs(en / restitutions[m] - 1));
      worst_time = std::max(worst_time, std::fabs(contact_time(frames, i, phases[p], dt) / tcol - 1));
    }
    errors[m].en.push_back(worst_en);
    errors[m].tcol.push_back(worst_time);
  }
}

void report_and_check(const std::string& title, const std::vector<double>& restitutions,
                      const std::vector<Errors>& errors, double blind) {
  std::printf("%s: relative error, largest over %zu phases\n%6s %10s", title.c_str(), phases.size(), "en", "");
  for (int steps : steps_per_contact) std::printf("  tcol/%-4d", steps);
  std::printf("  order\n");
  for (std::size_t m = 0; m < errors.size(); ++m)
    for (const auto& [what, series] : {std::pair{"tcol", &errors[m].tcol}, std::pair{"en", &errors[m].en}}) {
      std::printf("%6g %10s", restitutions[m], what);
      for (double e : *series) std::printf("  %9.2e", e);
      const double order = std::log2((*series)[2] / (*series)[3]);
      std::printf("  %5.2f\n", order);
      if (restitutions[m] > blind && series == &errors[m].tcol) continue;
      CHECK((*series)[1] <= 1e-3);
      CHECK(order == Approx(2).margin(0.25));
    }
}

}  // namespace engines::collisions
