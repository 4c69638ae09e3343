#include "falling.hpp"

#include "impact.hpp"

#include <ricochet/support/root.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ricochet::verify::benchmarks {

namespace {

constexpr double g = 9.80665;  // MFiX's; of DEM04 9.81, as published

// linear1 of a spring k and a restitution e: c = 2 √(mk) |ln e|/√(π² + ln²e).
Linear linear(double k, double mass, double en) {
  const double loss = -std::log(en);
  return {k, 2 * std::sqrt(mass * k / (std::numbers::pi * std::numbers::pi + loss * loss)) * loss};
}

/// A sphere on a floor under gravity, m y'' = −k(y − r) − c y' − mg from y = r on, until y is r again.
class Bounce {
 public:
  Bounce(const Linear& law, double mass, double radius, double speed)
      : radius_(radius), decay_(0.5 * law.c() / mass), sag_(g * mass / law.k()) {
    frequency_ = std::sqrt(law.k() / mass - decay_ * decay_);
    sine_ = (decay_ * sag_ - speed) / frequency_;
    const auto height = [this](double t) { return at(t) - radius_; };
    // Half a swing after the touch it is still below, three quarters of one after above.
    const double low = std::numbers::pi / frequency_, high = 1.5 * low;
    duration_ = support::root(height, low, high, height(low), height(high), {.relative = 0x1p-50});
  }
  double duration() const { return duration_; }
  double at(double t) const {
    const double phase = frequency_ * t;
    return radius_ - sag_ + std::exp(-decay_ * t) * (sag_ * std::cos(phase) + sine_ * std::sin(phase));
  }
  double speed_after() const {
    const double phase = frequency_ * duration_;
    const double swing = sag_ * std::cos(phase) + sine_ * std::sin(phase);
    const double turned = sine_ * std::cos(phase) - sag_ * std::sin(phase);
    return std::exp(-decay_ * duration_) * (frequency_ * turned - decay_ * swing);
  }

 private:
  double radius_, decay_, sag_, frequency_ = 0, sine_ = 0, duration_ = 0;
};

/// DEM01 and DEM02: 0.2 m, 2600 kg/m³, let go at 0.5 m.
struct Drop {
  static constexpr double radius = 0.1, density = 2600, height = 0.5;
  double k, en;

  Sphere sphere() const { return {radius, density}; }
  Linear law() const { return linear(k, sphere().mass(), en); }
  double touch() const { return std::sqrt(2 * (height - radius) / g); }
  Bounce bounce(double fall) const { return {law(), sphere().mass(), radius, std::sqrt(2 * g * fall)}; }
  Bounce bounce() const { return bounce(height - radius); }
  double tcol() const { return std::numbers::pi * std::sqrt(sphere().mass() / k); }
  ClusterSetup setup() const {
    ClusterSetup s = against_wall(sphere(), {law(), {}, ContactEnd::overlap});
    s.spheres[0].position.z = height;
    s.gravity = {0, 0, -g};
    return s;
  }
  double height_at(double time) const {
    if (time <= touch()) return height - 0.5 * g * time * time;
    const Bounce b = bounce();
    const double later = time - touch() - b.duration();
    return later <= 0 ? b.at(time - touch()) : radius + b.speed_after() * later - 0.5 * g * later * later;
  }
};

double simulated_height(const ClusterSetup& setup, double time, double step) {
  const double steps = std::ceil(time / step);
  Cluster cluster(setup, {.step = time / steps});
  cluster.advance(static_cast<std::uint64_t>(steps));
  return cluster.position(0).z;
}

/// DEM01: heights of the centre at two times that MFiX's own reference prints the closed form for, in contact and
/// after it; when and how fast it leaves.
std::vector<Row> fall_rows(Drop drop, const std::vector<std::pair<double, std::optional<double>>>& heights) {
  const std::string test = fmt::format("MFiX DEM01, k = {:g}, e = {}", drop.k, drop.en);
  std::vector<Asked> asked;
  asked.reserve(heights.size() + 2);
  for (const auto& [time, printed] : heights)
    asked.push_back({.test = test,
                     .quantity = fmt::format("height at {} s", time),
                     .unit = "m",
                     .exact = drop.height_at(time),
                     .scale = Drop::height,
                     .published = printed,
                     .reading = 2e-8});  // the time is rounded to 1e-8 s
  const Bounce b = drop.bounce();
  asked.push_back({.test = test,
                   .quantity = "end of the contact",
                   .unit = "s",
                   .exact = drop.touch() + b.duration(),
                   .scale = drop.tcol()});
  asked.push_back(
      {.test = test, .quantity = "speed then", .unit = "m/s", .exact = b.speed_after(), .scale = b.speed_after()});
  const ClusterSetup setup = drop.setup();
  return measure(asked, drop.tcol(), [&](double step) {
    std::vector<double> values;
    values.reserve(asked.size());
    for (const auto& [time, printed] : heights) values.push_back(simulated_height(setup, time, step));
    Cluster cluster(setup, {.step = step});
    std::vector<Encounter> done;
    while (done.empty()) cluster.step(), done = cluster.take_finished();
    // Free flight is exact: back from here to the separation.
    const double since = cluster.time() - done[0].separation;
    values.push_back(done[0].end);
    values.push_back(cluster.velocity(0).z + g * since);
    return values;
  });
}

/// DEM02: heights of the bounces; a hard sphere's are r + (h − r) e^{2n}.
std::vector<Row> bounce_rows(Drop drop) {
  constexpr int bounces = 3;
  const std::string test = fmt::format("MFiX DEM02, k = {:g}, e = {}", drop.k, drop.en);
  std::vector<Asked> asked;
  asked.reserve(bounces);
  double fall = Drop::height - Drop::radius;
  for (int n = 1; n <= bounces; ++n) {
    const double up = drop.bounce(fall).speed_after();
    fall = 0.5 * up * up / g;
    asked.push_back({.test = test,
                     .quantity = fmt::format("height of bounce {}", n),
                     .unit = "m",
                     .exact = Drop::radius + fall,
                     .scale = fall});
  }
  const ClusterSetup setup = drop.setup();
  return measure(asked, drop.tcol(), [&](double step) {
    Cluster cluster(setup, {.step = step});
    std::vector<double> heights;
    while (heights.size() < bounces) {
      cluster.step();
      if (cluster.take_finished().empty()) continue;
      const double up = cluster.velocity(0).z;
      heights.push_back(cluster.position(0).z + 0.5 * up * up / g);
    }
    return heights;
  });
}

/// DEM03: 1 mm spheres of 20000 and 10000 kg/m³ between walls 1.8 mm apart, at a quarter and three quarters of it.
class Pressed {
 public:
  explicit Pressed(double en) : en_(en) {}

  ClusterSetup setup() const {
    ClusterSetup s;
    s.spheres = {lower(), upper()};
    s.spheres[1].material = 1;
    s.walls = {{{0, 0, 0}, {0, 0, 1}, 2}, {{0, 0, gap}, {0, 0, -1}, 2}};
    s.gravity = {0, 0, -g};
    const auto meet = [&](std::size_t a, std::size_t b, double mass) {
      s.interactions.insert({{a, b}, {linear(k, mass, en_), {}, ContactEnd::overlap}});
    };
    meet(0, 1, pair_mass()), meet(0, 2, lower().mass()), meet(1, 2, upper().mass());
    return s;
  }

  /// Heights after `time`, by the classical Runge-Kutta rule on steps of a 50000th of a swing: 1e-13.
  std::array<double, 2> exact(double time) const {
    constexpr int steps = 40000;
    State s{lower().position.z, upper().position.z, 0, 0};
    const double h = time / steps;
    for (int n = 0; n < steps; ++n) {
      const State a = rate(s), b = rate(moved(s, a, h / 2)), c = rate(moved(s, b, h / 2)), d = rate(moved(s, c, h));
      for (std::size_t i = 0; i < s.size(); ++i) s[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    return {s[0], s[1]};
  }
  double tcol() const { return std::numbers::pi * std::sqrt(pair_mass() / k); }

 private:
  using State = std::array<double, 4>;  // heights, velocities
  static constexpr double radius = 0.5e-3, gap = 1.8e-3, k = 1e3;

  static Sphere lower() { return {radius, 2e4, {0, 0, gap / 4}}; }
  static Sphere upper() { return {radius, 1e4, {0, 0, 3 * gap / 4}}; }
  static double pair_mass() { return lower().mass() * upper().mass() / (lower().mass() + upper().mass()); }
  static State moved(const State& s, const State& by, double h) {
    return {s[0] + h * by[0], s[1] + h * by[1], s[2] + h * by[2], s[3] + h * by[3]};
  }
  State rate(const State& s) const {
    const double m1 = lower().mass(), m2 = upper().mass();
    const auto force = [&](double mass, double overlap, double approach) {
      const Linear law = linear(k, mass, en_);
      return law.k() * overlap + law.c() * approach;
    };
    const double below = force(m1, radius - s[0], -s[2]),
                 between = force(pair_mass(), 2 * radius - s[1] + s[0], s[2] - s[3]),
                 above = force(m2, radius - gap + s[1], s[3]);
    return {s[2], s[3], (below - between) / m1 - g, (between - above) / m2 - g};
  }

  double en_;
};

std::vector<Row> pressed_rows(double en) {
  constexpr double time = 1e-3;
  const Pressed pressed(en);
  const std::array<double, 2> exact = pressed.exact(time);
  const std::string test = fmt::format("MFiX DEM03, e = {}", en);
  const std::vector<Asked> asked{
      {.test = test, .quantity = "height of the lower at 1 ms", .unit = "m", .exact = exact[0], .scale = 1e-4},
      {.test = test, .quantity = "height of the upper at 1 ms", .unit = "m", .exact = exact[1], .scale = 1e-4}};
  const ClusterSetup setup = pressed.setup();
  return measure(asked, pressed.tcol(), [&](double step) {
    const double steps = std::ceil(time / step);
    Cluster cluster(setup, {.step = time / steps});
    cluster.advance(static_cast<std::uint64_t>(steps));
    return std::vector<double>{cluster.position(0).z, cluster.position(1).z};
  });
}

/// DEM04: 1 mm, 10000 kg/m³, on a floor of k = 1e4 N/m at rest but for 0.5 m/s along it. It slides until it rolls, the
/// rigid law's arm being r less half the overlap: with q = m s²/J, t = v₀/((1+q) μg) and v = v₀ q/(1+q).
std::vector<Row> sliding_rows(double mu, std::optional<std::pair<double, double>> printed) {
  constexpr double k = 1e4, speed = 0.5, gravity = 9.81;
  Sphere s{0.5e-3, 1e4, {}, {speed, 0, 0}};
  const double sag = s.mass() * gravity / k, arm = s.radius - 0.5 * sag, q = s.mass() * arm * arm / s.inertia();
  ClusterSetup setup = against_wall(s, {Linear(k, 0), Friction(mu, mu, 0)});
  setup.spheres[0].position.z = s.radius - sag;
  setup.gravity = {0, 0, -gravity};
  const double time = speed / ((1 + q) * mu * gravity), rolling = speed * q / (1 + q);
  const std::string test = fmt::format("MFiX DEM04, mu = {}", mu);
  std::vector<Asked> asked{
      {.test = test, .quantity = "end of sliding", .unit = "s", .exact = time, .scale = time, .check = Check::rounding},
      {.test = test,
       .quantity = "speed then",
       .unit = "m/s",
       .exact = rolling,
       .scale = speed,
       .check = Check::rounding}};
  // Published for an arm of r: 2v₀/(7μg) and 5v₀/7, which the sag moves by 1e-5 of themselves at most.
  if (printed) {
    asked[0].published = printed->first, asked[0].reading = 5e-7;
    asked[1].published = printed->second, asked[1].reading = 1e-6;
  }
  // Nothing but the floor's spring has to be resolved, and that is at rest.
  const double coarse = 10 * std::numbers::pi * std::sqrt(s.mass() / k);
  return measure(asked, coarse, [&](double step) {
    Cluster cluster(setup, {.step = step});
    double rolls = Encounter::never;
    while (!std::isfinite(rolls)) {
      cluster.step();
      rolls = cluster.contacts()[0].record.phase_begin[static_cast<std::size_t>(Phase::rolling)];
    }
    return std::vector<double>{rolls, cluster.velocity(0).x};
  });
}

}  // namespace

std::vector<Row> falling_rows() {
  std::vector<Row> rows;
  const auto append = [&rows](const std::vector<Row>& more) { rows.insert(rows.end(), more.begin(), more.end()); };
  append(fall_rows({1e4, 0.9}, {{0.30074181, 0.05863557}, {0.45037920, 0.21731611}}));
  append(fall_rows({1e5, 0.6}, {{0.4, std::nullopt}}));
  for (const double k : {5e4, 5e5}) append(bounce_rows({k, 0.9}));
  for (const double en : {1.0, 0.5}) append(pressed_rows(en));
  append(sliding_rows(0.2, {}));
  append(sliding_rows(0.5, std::pair(0.0291250, 0.357142)));
  append(sliding_rows(1, {}));
  return rows;
}

}  // namespace ricochet::verify::benchmarks
