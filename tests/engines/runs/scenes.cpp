#include "scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <random>

namespace engines {

namespace crossing {

std::vector<Grain> pair(int axis, double drift) {
  const double gap = 10 * dt * speed;
  Grain a{.radius = radius}, b{.radius = radius};
  const double middle = -drift * (10 * dt + 0.4 * tcol);
  a.position[0] = b.position[0] = middle;
  if (axis == 0) a.position[0] += drift > 0 ? -radius : radius;  // so that one of them crosses while they touch
  if (axis == 0) b.position[0] += drift > 0 ? -radius : radius;
  a.position[axis] -= radius + gap / 2;
  b.position[axis] += radius + gap / 2;
  a.velocity[0] = b.velocity[0] = drift;
  a.velocity[axis] += speed / 2;
  b.velocity[axis] -= speed / 2;
  return {a, b};
}

int crossings_in_contact(const std::vector<Frame>& frames, std::size_t i) {
  int count = 0;
  for (std::size_t n = 1; n < frames.size(); ++n) {
    const Vector& f = frames[n].force[i];
    const bool touching = f[0] != 0 || f[1] != 0 || f[2] != 0;
    count += touching && (frames[n - 1].position[i][0] < 0) != (frames[n].position[i][0] < 0);
  }
  return count;
}

}  // namespace crossing

namespace bouncing {

namespace {

constexpr double speed = 0.5, radius = 1.5e-3;
constexpr int bounces = 5;

std::vector<Frame> frames_of(const std::string& name, const Deck& deck, int ranks) {
  const Workplace place("bounces_" + name + "_" + std::to_string(ranks));
  REQUIRE(place.run(deck(place, ranks), ranks) == 0);
  CHECK(place.output().find("Neighbor list builds = 0") != std::string::npos);
  return place.frames("dump");
}

int bounces_in(const std::vector<Frame>& frames) {
  int count = 0;
  for (std::size_t n = 1; n < frames.size(); ++n)
    count += (frames[n - 1].velocity[0][0] < 0) != (frames[n].velocity[0][0] < 0);
  return count;
}

}  // namespace

std::string processors(int ranks) { return ranks == 2 ? "2 1 1" : "1 1 1"; }

std::vector<Grain> grains(bool obstacles) {
  std::vector<Grain> grains{{.position = {radius + room, 1e-3, 0}, .velocity = {-speed, 0, 0}}};
  if (obstacles) {
    grains.push_back({.position = {-radius, 1e-3, 0}});
    grains.push_back({.position = {3 * radius + room, 1e-3, 0}});
  }
  return grains;
}

int steps_of_run() {
  const double duration = room / speed * (1 - std::pow(1 / en, bounces)) / (1 - 1 / en) + (bounces + 0.7) * tcol;
  return static_cast<int>(duration / dt);
}

void check(const std::string& name, const Deck& deck, double difference) {
  const auto one = frames_of(name, deck, 1), two = frames_of(name, deck, 2);
  REQUIRE(bounces_in(one) == bounces);
  const double restitution = std::pow(std::fabs(one.back().velocity[0][0]) / speed, 1. / bounces);
  const double apart = largest_difference(one, two);
  std::printf("%s: en = %.6f a bounce (%g asked), 2 ranks differ from 1 by %.1e\n", name.c_str(), restitution, en,
              apart);
  CHECK(restitution == Approx(en).epsilon(1e-3));
  CHECK(apart <= difference);
}

}  // namespace bouncing

namespace pouring {

std::vector<Grain> loose_lattice() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1e-4, 1e-4), stir(-0.3, 0.3);
  std::vector<Grain> grains;
  for (int i = 0; i < side * side * side; ++i)
    grains.push_back(
        {.radius = radius,
         .position = {(i % side + 0.5) * spacing + shift(random), (i / side % side + 0.5) * spacing + shift(random),
                      (i / (side * side) + 0.5) * spacing},
         .velocity = {stir(random), stir(random), stir(random)}});
  return grains;
}

}  // namespace pouring

}  // namespace engines
