#include "../../core/src/motion/slides.hpp"

#include <catch2/catch.hpp>

#include <cstring>
#include <random>
#include <vector>

using namespace ricochet;
using motion::Slides;

namespace {

constexpr double step = 1e-5;
constexpr double k_t = 2000, c_t = 0.3;

double draw(std::mt19937& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}
Vec3 vector(std::mt19937& random, double size) {
  return {draw(random, -size, size), draw(random, -size, size), draw(random, -size, size)};
}

/// A contact whose springs hold, as the cluster describes it in two ways.
struct Case {
  ContactState contact;
  ContactGeometry geometry;
  SlipMobility mobility;
  Vec3 velocity, velocity_mid, spin_i, spin_j, spin_mid_i, spin_mid_j;
  bool wall;

  explicit Case(std::mt19937& random) : wall(random() % 3 == 0) {
    const Vec3 n = vector(random, 1);
    geometry.normal = n / norm(n);
    geometry.overlap = draw(random, 1e-6, 1e-4);
    geometry.arm_i = draw(random, 0.001, 0.01), geometry.arm_j = wall ? 0 : draw(random, 0.001, 0.01);
    mobility = {draw(random, 100, 1000), draw(random, -1, 1), draw(random, 1e4, 1e6)};
    velocity = vector(random, 0.1), velocity_mid = velocity + vector(random, 0.01);
    spin_i = vector(random, 10), spin_mid_i = spin_i + vector(random, 1);
    if (!wall) spin_j = vector(random, 10), spin_mid_j = spin_j + vector(random, 1);
    contact.approach.overlap = draw(random, 1e-6, 1e-4);
    contact.lag = random() % 4 == 0 ? 0.7 * step : step;
    contact.strained = draw(random, 0, 1e-6);
    contact.elongation.slide = tangential(vector(random, 1e-5), then());
    contact.friction.sliding = tangential(vector(random, 1e-6), then());
  }
  Vec3 then() const { return wall ? geometry.normal : motion::normal_before(geometry, velocity, contact.lag); }
};

void add(Slides& s, const Case& c, const TangentialLaw& law) {
  const std::size_t k = s.count++;
  const Spring before = spring(law, c.contact.approach.overlap), now = spring(law, c.geometry.overlap);
  const motion::compliant::Carried carried = motion::compliant::carried(before.stiffness, now.stiffness);
  s.normal.set(k, c.geometry.normal);
  s.arm_i[k] = c.geometry.arm_i, s.arm_j[k] = c.geometry.arm_j, s.wall[k] = c.wall ? 1 : 0;
  s.velocity.set(k, c.velocity), s.velocity_mid.set(k, c.velocity_mid);
  s.spin_i.set(k, c.spin_i), s.spin_j.set(k, c.spin_j);
  s.swing.set(k, c.geometry.arm_i * c.spin_mid_i + c.geometry.arm_j * c.spin_mid_j);
  s.elongation.set(k, c.contact.elongation.slide), s.last.set(k, c.contact.friction.sliding);
  s.span[k] = c.contact.lag, s.mobility[k] = c.mobility.slip, s.strained[k] = c.contact.strained;
  s.stiffness_then[k] = before.stiffness, s.stiffness[k] = now.stiffness, s.damping[k] = now.damping;
  s.of_strain[k] = carried.strain, s.of_motion[k] = carried.motion;
}

struct Outcome {
  Vec3 impulse, strain;
  double stored, lost;
};

/// By what a contact with any springs is stepped by, in tractions.
Outcome alone(const Case& c, const TangentialLaw& law) {
  const TangentialContact contact{.law = law, .friction = Friction(1e9, 1e9, 0)};
  motion::CompliantApproach a{.normal_then = c.then(),
                              .normal = c.geometry.normal,
                              .motion = motion::slip_of(c.geometry, c.velocity, c.spin_i, c.spin_j),
                              .pressing = {0, c.geometry.overlap, 0, 0.005},
                              .step = step};
  a.motion.slip -=
      c.contact.lag / step * motion::turning(c.geometry, c.velocity, c.spin_i, c.spin_j, c.wall, 0.5 * step);
  motion::CompliantRow row = motion::compliant_row<false>(contact, c.contact, a);
  SlipMotion free = motion::slip_of(c.geometry, c.velocity_mid, c.spin_mid_i, c.spin_mid_j);
  free.slip -= 0.5 * c.mobility.slip * tangential(c.contact.friction.sliding, c.geometry.normal);
  const FrictionProblem problem{1, 0, c.mobility, free, free, {}};
  const FrictionSolution found = motion::compliant_impulse<false>(contact, c.contact, row, problem, {});
  REQUIRE(found.sticks);
  SlipMotion mean = free;
  mean.slip += 0.5 * c.mobility.slip * found.impulse.sliding;
  const motion::CompliantEnd end = motion::compliant_end<false>(contact, row, c.contact, mean, 1);
  const motion::CompliantLoss loss = motion::compliant_loss(row, c.contact.strained - end.stored);
  return {found.impulse.sliding, end.elongation.slide, end.stored, motion::lost(loss, contact, found.impulse, mean)};
}

Slides drawn(std::mt19937& random) {
  Slides s{};
  while (s.count < Slides::lanes) add(s, Case(random), LinearTangential(k_t, c_t));
  return s;
}

}  // namespace

TEST_CASE("Contacts side by side are stepped as each alone") {
  std::mt19937 random(3);
  for (const TangentialLaw& law : {TangentialLaw(LinearTangential(k_t, c_t)), TangentialLaw(LinearTangential(k_t, 0)),
                                   TangentialLaw(MindlinTangential(100 * k_t, c_t))})
    for (int n = 0; n < 50; ++n) {
      std::vector<Case> cases;
      Slides s{};
      while (s.count < Slides::lanes) add(s, cases.emplace_back(random), law);
      motion::hold(s, step, Instructions::baseline);
      motion::conclude(s, step, Instructions::baseline);
      for (std::size_t k = 0; k < Slides::lanes; ++k) {
        const Outcome one = alone(cases[k], law);
        CAPTURE(name(law), cases[k].wall, cases[k].contact.lag);
        CHECK(norm(s.impulse[k] - one.impulse) <= 1e-13 * norm(one.impulse));
        CHECK(norm(s.strain[k] - one.strain) <= 1e-13 * norm(one.strain));
        CHECK(std::abs(s.stored[k] - one.stored) <= 1e-13 * one.stored);
        CHECK(std::abs(s.lost[k] - one.lost) <= 1e-12 * (std::abs(one.lost) + cases[k].contact.strained + one.stored));
        const Vec3 lever = cross(cases[k].geometry.normal, one.impulse);
        CHECK(norm(s.on_i[k] - cases[k].geometry.arm_i * lever) <= 1e-13 * norm(s.on_i[k]));
        CHECK(norm(s.on_j[k] - cases[k].geometry.arm_j * lever) <= 1e-13 * norm(s.on_j[k]));
      }
    }
}

TEST_CASE("A spring that grows or shrinks while it slides relaxes as its equation says, at second order") {
  // Growing f' = k (q - f)/c, shrinking ξ' = (q - k ξ)/c, with k and q linear in time: by Runge and Kutta's steps.
  const double c = 3, start = 0.8, q0 = 2, q1 = 2.7;
  const double k0 = 40, k1 = GENERATE(90.0, 15.0);
  const bool grows = k1 > k0;
  CAPTURE(k1);
  // Of one step over a share of their change: of third order.
  const auto error = [&](double share) {
    const double h = 0.2 * share, k_end = k0 + (k1 - k0) * share, q_end = q0 + (q1 - q0) * share;
    double y = grows ? k0 * start : start;
    constexpr int n = 2000;
    for (int i = 0; i < n; ++i) {
      const auto rate = [&](double s, double at) {
        const double k = k0 + (k_end - k0) * s, q = q0 + (q_end - q0) * s;
        return grows ? k * (q - at) / c : (q - k * at) / c;
      };
      const double s = double(i) / n, d = h / n, a = rate(s, y), b = rate(s + 0.5 / n, y + 0.5 * d * a),
                   g = rate(s + 0.5 / n, y + 0.5 * d * b), e = rate(s + 1.0 / n, y + d * g);
      y += d / 6 * (a + 2 * b + 2 * g + e);
    }
    const Vec3 found = motion::compliant::slid({k0, c}, {k_end, c}, {start, 0, 0}, {q0, 0, 0}, {q_end, 0, 0}, h);
    return std::abs(found.x - (grows ? y / k_end : y));
  };
  CHECK(std::log2(error(0.04) / error(0.02)) == Approx(3).margin(0.1));
  CHECK(std::log2(error(0.02) / error(0.01)) == Approx(3).margin(0.05));
  // Without a dashpot nothing is remembered; without a spring nothing is strained.
  CHECK(motion::compliant::slid({k0, 0}, {k1, 0}, {start, 0, 0}, {q0, 0, 0}, {q1, 0, 0}, 0.2).x == Approx(q1 / k1));
  CHECK(motion::compliant::slid({k0, c}, {0, c}, {start, 0, 0}, {q0, 0, 0}, {0, 0, 0}, 0.2) == Vec3{});
}

TEST_CASE("Contacts side by side get the same bits by all instructions") {
  if (widest_instructions() == Instructions::baseline) {
    WARN("skipped: this machine has no AVX2");
    return;
  }
  std::mt19937 random(4);
  for (int n = 0; n < 100; ++n) {
    Slides narrow = drawn(random), wide = narrow;
    motion::hold(narrow, step, Instructions::baseline), motion::hold(wide, step, Instructions::avx2);
    narrow.slides[n % Slides::lanes] = wide.slides[n % Slides::lanes] = 1;
    motion::conclude(narrow, step, Instructions::baseline), motion::conclude(wide, step, Instructions::avx2);
    CHECK(std::memcmp(&narrow, &wide, sizeof narrow) == 0);
  }
}
