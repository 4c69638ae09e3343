#include "../paper.hpp"
#include "figures.hpp"
#include "run.hpp"
#include "sign.hpp"

#include <verify/registry.hpp>

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {
namespace {

using cluster::Overlap;
using cluster::Run;
using console::Json;
using console::Notation;
using console::Table;

constexpr double strong_alpha = paper::five_spheres.strong_alpha, weak_alpha = paper::five_spheres.weak_alpha;
constexpr double printed_k = paper::five_spheres.k;
constexpr double stiffnesses[] = {1e3, 1e4, 1e5, 1e6, 1e7};
constexpr double duration = 0.03, sampling = 1e-4;  // s

// A 200th of what the lightest pair's collision lasts, and no coarser than what Figs. 7-9 are drawn with.
double step_for(double alpha, double k) {
  return std::min(4e-6, stiffest_contact(cluster::five_spheres(alpha, k)).tcol / 200);
}

Run run(double alpha, double k) { return cluster::run(alpha, k, duration, step_for(alpha, k), sampling); }

Table collisions(const Run& run) {
  Table table({{"pair"},
               {"t_begin", "ms", {Notation::Kind::fixed, 4}},
               {"t_end", "ms", {Notation::Kind::fixed, 4}},
               {"t_col", "ms", {Notation::Kind::fixed, 4}},
               {"separation", "ms", {Notation::Kind::fixed, 4}},
               {"ended"},
               {"phases"}},
              fmt::format("Fig. 9: collisions at α = {}, k = {} kg/s²", run.alpha, run.k));
  for (const Encounter& e : run.collisions) {
    std::string phases;
    for (std::size_t p = 0; p < phase_count; ++p)
      if (std::isfinite(e.phase_begin[p]))
        phases += fmt::format("{}{}", phases.empty() ? "" : ", ", name(static_cast<Phase>(p)));
    table.row({cluster::pair_name(e), 1e3 * e.begin, console::number_or_blank(1e3 * e.end),
               console::number_or_blank(1e3 * (e.end - e.begin)), console::number_or_blank(1e3 * e.separation),
               std::string(name(e.how)), phases});
  }
  return table;
}

Table shares(const std::vector<Run>& strong, const std::vector<Run>& weak) {
  Table table({{"alpha"},
               {"k", "kg/s^2", {Notation::Kind::significant, 2}},
               {"collisions"},
               {"mean t_col", "ms", {Notation::Kind::fixed, 4}},
               {"any pair collides", "ms", {Notation::Kind::fixed, 4}},
               {"several do", "%", {Notation::Kind::fixed, 1}},
               {"pairs at once, mean", "", {Notation::Kind::fixed, 3}},
               {"most"},
               {"kinetic energy left", "%", {Notation::Kind::fixed, 2}}},
              "Binary or multiparticle: how the collisions share the time");
  for (const auto* runs : {&strong, &weak})
    for (const Run& r : *runs) {
      const Overlap o = cluster::overlap(r.collisions, duration);
      table.row({r.alpha, r.k, static_cast<std::int64_t>(r.collisions.size()), 1e3 * o.mean_duration, 1e3 * o.busy,
                 100 * o.shared, o.mean_pairs, static_cast<std::int64_t>(o.most_pairs), 100 * r.kinetic_left});
    }
  table.note(
      "k = 1000 is what the paper prints. Then also the strong collisions are longer than the pauses between them.");
  return table;
}

// Greatest difference of any velocity at the end [m/s].
double distance(const Run& a, const Run& b) {
  double worst = 0;
  for (std::size_t i = 0; i < 5; ++i)
    worst = std::max(worst, norm(a.samples.back().velocity[i] - b.samples.back().velocity[i]));
  return worst;
}

struct Convergence {
  double alpha, step;
  double velocity[3], energy[3];  // errors at step, step/2, step/4
  double velocity_order, energy_order;
};

Convergence converge(double alpha) {
  Convergence c{.alpha = alpha, .step = 4e-5, .velocity = {}, .energy = {}, .velocity_order = 0, .energy_order = 0};
  const Run exact = cluster::run(alpha, printed_k, duration, c.step / 64, sampling * 10);
  for (int n = 0; n < 3; ++n) {
    const Run r = cluster::run(alpha, printed_k, duration, c.step / (1 << n), sampling * 10);
    c.velocity[n] = distance(r, exact);
    c.energy[n] = r.energy_drift;
  }
  c.velocity_order = 0.5 * std::log2(c.velocity[0] / c.velocity[2]);
  c.energy_order = 0.5 * std::log2(c.energy[0] / c.energy[2]);
  return c;
}

Table convergence_table(const std::vector<Convergence>& all) {
  const Notation sci{Notation::Kind::scientific, 2}, two{Notation::Kind::fixed, 2};
  Table table({{"alpha"},
               {"step", "s", sci},
               {"velocities", "m/s", sci},
               {"halved", "m/s", sci},
               {"quartered", "m/s", sci},
               {"order", "", two},
               {"energy balance", "", sci},
               {"halved ", "", sci},
               {"quartered ", "", sci},
               {"order ", "", two}},
              "Convergence: error of the velocities at the end and of the energy balance, k = 1000 kg/s²");
  for (const Convergence& c : all)
    table.row({c.alpha, c.step, c.velocity[0], c.velocity[1], c.velocity[2], c.velocity_order, c.energy[0], c.energy[1],
               c.energy[2], c.energy_order});
  table.note("Stated order 2, and 2-α at least for what the force's start like t^(1-α) adds.");
  return table;
}

void conservation_gates(std::vector<Gate>& gates, const Run& r) {
  const std::string at = fmt::format(", alpha = {}", r.alpha);
  gates.push_back(at_most("momentum, greatest relative change" + at, r.momentum_drift, 1e-12));
  gates.push_back(at_most("angular momentum, greatest relative change" + at, r.angular_drift, 1e-12));
  gates.push_back(at_most("kinetic and stored energy, greatest relative rise" + at, r.energy_growth, 1e-6));
}

std::vector<Gate> gates(const std::vector<Run>& strong, const std::vector<Run>& weak,
                        const std::vector<Convergence>& orders) {
  std::vector<Gate> all;
  conservation_gates(all, strong.front());
  conservation_gates(all, weak.front());
  for (const Convergence& c : orders) {
    const std::string at = fmt::format(", alpha = {}", c.alpha);
    all.push_back(between("order of the velocities" + at, c.velocity_order, 2 - c.alpha - 0.3, 2.5));
    all.push_back(between("order of the energy balance" + at, c.energy_order, 2 - c.alpha - 0.3, 2.5));
  }
  const auto at = [](const std::vector<Run>& runs, double k) {
    for (const Run& r : runs)
      if (r.k == k) return cluster::overlap(r.collisions, duration);
    return Overlap{};
  };
  // The paper: collisions are longer when repulsion is weak; strong ones are binary, weak ones overlap.
  all.push_back(at_least("weak over strong, mean t_col at k = 1000",
                         at(weak, printed_k).mean_duration / at(strong, printed_k).mean_duration, 1));
  all.push_back(at_most("strong, k = 1e6: most pairs at once (binary)", at(strong, 1e6).most_pairs, 1));
  all.push_back(at_most("strong, k = 1e7: most pairs at once (binary)", at(strong, 1e7).most_pairs, 1));
  for (const Run& r : weak)
    all.push_back(
        at_least(fmt::format("weak, k = {}: most pairs at once (multiparticle)", console::significant(r.k, 1)),
                 cluster::overlap(r.collisions, duration).most_pairs, 3));
  return all;
}

std::string verdict(const std::vector<Run>& strong, const std::vector<Run>& weak) {
  const Overlap s = cluster::overlap(strong.front().collisions, duration),
                w = cluster::overlap(weak.front().collisions, duration),
                hard = cluster::overlap(strong[3].collisions, duration);
  return fmt::format(
      "With the printed k = 1000 the strong collisions ({} ms on average) overlap too, {:.0f} % of the time; at k = "
      "1e6 "
      "{:.0f} %, and they are binary as the paper shows them. Weak ones ({} ms) are multiparticle at every k, up to {} "
      "pairs at once.",
      console::significant(1e3 * s.mean_duration, 3), 100 * s.shared, 100 * hard.shared,
      console::significant(1e3 * w.mean_duration, 3), w.most_pairs);
}

class ClusterStudy : public Study {
 public:
  std::string name() const override { return "cluster"; }
  std::string claim() const override {
    return "Figs. 7-9: five spheres in space, binary collisions at alpha = 0.01, multiparticle ones at alpha = 0.97";
  }
  StudyResult run(const RunOptions&) override {
    std::vector<Run> strong, weak;
    for (double k : stiffnesses) {
      strong.push_back(verify::run(strong_alpha, k));
      weak.push_back(verify::run(weak_alpha, k));
    }
    const std::vector<Convergence> orders{converge(strong_alpha), converge(weak_alpha)};
    StudyResult result;
    result.gates = gates(strong, weak, orders);
    result.tables = {shares(strong, weak), collisions(strong.front()), collisions(weak.front()),
                     convergence_table(orders)};
    const auto signs = cluster::sign_cases();
    result.tables.push_back(cluster::sign_table(signs));
    for (const Gate& gate : cluster::sign_gates(signs)) result.gates.push_back(gate);
    result.figures = {
        cluster::trajectories(strong.front(), weak.front()), cluster::velocities(strong.front(), weak.front()),
        cluster::sequence(strong.front(), weak.front(), duration), cluster::binary(strong, weak, duration)};
    result.verdict = verdict(strong, weak);
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> cluster_study() { return std::make_unique<ClusterStudy>(); }

}  // namespace ricochet::verify
