// Any doubles to the numerical interface: an answer that is finite wherever it is called good, or the exception that
// the header names. The first byte chooses the function, the rest are its arguments.

#include "arguments.hpp"

#include <calibrate/calibration.hpp>
#include <ricochet/ricochet.hpp>

#include <stdexcept>

using namespace ricochet;

namespace {

void expect_good(const Collision& c) {
  expect_finite({c.tcol, c.en, c.max_overlap, c.time_max_overlap, c.max_force, c.time_max_force, c.overlap_end});
  if (c.separated() && !(c.tcol > 0 && c.en >= 0 && c.en <= 1 + 1e-9))
    throw std::logic_error("an impossible collision");
}

void a_collision(Arguments& in) {
  const Impact impact{in.number(), in.number()};
  CollideOptions options;
  const std::uint8_t how = in.byte();
  options.end = how & 1 ? ContactEnd::overlap : ContactEnd::force;
  options.method = how & 2 ? CollideMethod::numerical : CollideMethod::automatic;
  options.max_evaluations = 20000;
  const double p = in.number(), q = in.number();
  switch ((how >> 2) % 5) {
    case 0: return expect_good(collide(Linear(p, q), impact, options));
    case 1: return expect_good(collide(KuwabaraKono(p, q), impact, options));
    case 2: return expect_good(collide(Tsuji(p, q), impact, options));
    case 3: return expect_good(collide(Hysteretic(p, q), impact, options));
    default: return expect_good(collide(Fractional(p, q, in.share()), impact, options));
  }
}

void a_calibration(Arguments& in) {
  calibration::Settings settings;
  settings.method = calibration::Method::direct;
  const auto law = LawKind::all()[in.byte() % Laws::size];
  const auto end = in.byte() & 1 ? ContactEnd::overlap : ContactEnd::force;
  const double tcol = in.number(), en = in.share();
  try {
    const auto outcome = calibration::calibrate({law, end, {tcol, en, {in.number(), in.number()}}}, settings);
    if (const auto* found = std::get_if<calibration::Calibration>(&outcome)) {
      expect_good(found->achieved);
      for (const auto& parameter : parameters(found->law)) expect_finite({parameter.value});
    }
  } catch (const calibration::NotConverged&) {
  }
}

void a_kernel(Arguments& in) {
  const double shortest = in.number();
  const MemoryKernel kernel = memory_kernel(in.share(), shortest, shortest * (1 + 999 * in.share()), in.number());
  expect_finite({kernel.spring(), kernel.dashpot(), kernel.error()});
  for (const Arm& arm : kernel.arms()) {
    expect_finite({arm.strength, arm.rate});
    if (!(arm.strength > 0 && arm.rate > 0)) throw std::logic_error("an arm that is not passive");
  }
}

AnyLaw a_law(Arguments& in, std::uint8_t which) {
  const double p = in.number(), q = in.number();
  switch (which % 5) {
    case 0: return Linear(p, q);
    case 1: return KuwabaraKono(p, q);
    case 2: return Tsuji(p, q);
    case 3: return Hysteretic(p, q);
    default: return Fractional(p, q, in.share());
  }
}

/// At most three beads for at most 2000 steps, and a kernel of few arms: only a hang takes long.
void a_column(Arguments& in) {
  const std::uint8_t how = in.byte();
  Column column;
  for (int bead = 0; bead <= how % 3; ++bead) {
    column.mass.push_back(in.number());
    column.gap.push_back(in.share());
    column.velocity.push_back(in.number());
  }
  ColumnOptions options;
  options.step = in.number();
  options.duration = 2000 * options.step;
  options.memory_tolerance = 1e-3;
  if (how & 64) column.gravity = in.number();
  if (how & 128) options.reclosing = Reclosing::silent;
  const std::uint8_t which = in.byte();
  if (which & 128) options.end = ContactEnd::overlap;
  const AnyLaw plate = a_law(in, which), pair = a_law(in, which);
  const ColumnResult r = run_column(column, plate, pair, options);
  expect_finite({r.time, r.energy_ratio, r.last_contact_time});
  for (const double v : r.velocity) expect_finite({v});
  if (r.end == ColumnEnd::broke_down ? !r.velocity.empty() : r.velocity.size() != column.mass.size())
    throw std::logic_error("a column that lost its beads");
}

/// Two spheres and a plate for 100 steps.
void a_cluster(Arguments& in) {
  const std::uint8_t which = in.byte();
  ClusterSetup setup;
  const auto vector = [&] { return Vec3{in.number(), in.number(), in.number()}; };
  for (int k = 0; k < 2; ++k)
    setup.spheres.push_back(
        {in.share(), in.number(), {in.share(), in.share(), 2.0 * k + in.share()}, vector(), vector(), 0});
  if (which & 128) setup.walls.push_back({vector(), vector(), 0});
  const double step = in.number(), mu = in.share();
  setup.interactions.insert(
      {{0, 0}, {a_law(in, which), Friction(mu, mu, 0), which & 64 ? ContactEnd::overlap : ContactEnd::force}});
  setup.gravity = {0, 0, in.share()};
  Cluster cluster(setup, {.step = step, .longest_contact = 100 * step, .kernel_tolerance = 1e-3});
  if (!cluster.advance(100)) return;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    const Vec3 v = cluster.velocity(i), w = cluster.spin(i);
    expect_finite({v.x, v.y, v.z, w.x, w.y, w.z});
  }
  expect_finite({stiffest_contact(setup).tcol});
}

void run(Arguments& in) {
  switch (in.byte() % 8) {
    case 0: return expect_finite({mittag_leffler(in.number(), in.number(), in.number())});
    case 1: return expect_finite({MittagLeffler(in.number(), in.number())(in.number())});
    case 2: {
      const FractionalContact c =
          fractional_contact(in.share(), in.byte() & 1 ? ContactEnd::overlap : ContactEnd::force);
      return expect_finite({c.z_star, c.tau, c.en, c.overlap_end, c.max_overlap, c.max_force});
    }
    case 3: return a_collision(in);
    case 4: return a_calibration(in);
    case 6: return a_column(in);
    case 7: return a_cluster(in);
    default: return a_kernel(in);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Arguments in(data, size);
  try {
    run(in);
  } catch (const std::invalid_argument&) {
  } catch (const std::overflow_error&) {  // mittag_leffler, where the value is past the largest double
  }
  return 0;
}
