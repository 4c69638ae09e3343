#include "oblique_cases.hpp"

#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <ricochet/collision/tangential_restitution.hpp>

#include <algorithm>
#include <optional>

using namespace oblique;

namespace {

rc::Gen<double> within(double low, double high) {
  constexpr int parts = 1'000'000;
  return rc::gen::map(rc::gen::inRange(0, parts + 1), [=](int i) { return low + (high - low) * i / parts; });
}
rc::Gen<double> decades(double low, double high) {
  return rc::gen::map(within(low, high), [](double x) { return std::pow(10, x); });
}

Vec3 any_vector(double size) { return {*within(-size, size), *within(-size, size), *within(-size, size)}; }

/// Mass 1, speed of approach around 1, t_col around π.
AnyLaw any_law() {
  switch (*rc::gen::inRange(0, 5)) {
    case 0: return Linear(1, *rc::gen::element(0.0, 0.1, 1.0, 4.0));
    case 1: return KuwabaraKono(1, *within(0, 2));
    case 2: return Tsuji(1, *within(0, 2));
    case 3: return Hysteretic(1, *within(1, 10));
    default: return Fractional(1, 1, *within(0, 0.9));
  }
}

TangentialContact any_tangential() {
  const double k = *decades(-2, 2), c = *rc::gen::element(0.0, 0.03, 0.5);
  TangentialContact contact;
  switch (*rc::gen::inRange(0, 3)) {
    case 0: contact.law = RigidTangential{}; break;
    case 1: contact.law = LinearTangential(k, c); break;
    default: contact.law = MindlinTangential(k, c);
  }
  const double mu = *within(0.01, 1);
  contact.friction = Friction(mu, mu * *rc::gen::element(0.3, 1.0), *within(0, 1), *rc::gen::element(0.0, 0.5));
  if (*rc::gen::arbitrary<bool>())
    contact.torsion = {Torsion::Limit::separate, {*decades(-2, 0), *rc::gen::element(0.0, 0.01)}};
  if (!compliant(contact.law) && *rc::gen::arbitrary<bool>()) contact.torsion.limit = Torsion::Limit::disc;
  contact.rolling = {*rc::gen::element(0.0, 0.05), {*decades(-2, 0), *rc::gen::element(0.0, 0.01)}};
  return contact;
}

ObliqueImpact any_impact() {
  ObliqueImpact impact;
  impact.normal = any_vector(1);
  if (norm(impact.normal) < 0.1) impact.normal = {0, 0, 1};
  const auto body = [] { return ImpactBody{*decades(-0.5, 0.5), *decades(0.7, 1.3), any_vector(1), any_vector(0.3)}; };
  impact.i = body();
  impact.j = *rc::gen::arbitrary<bool>() ? ImpactBody::wall(any_vector(1)) : body();
  const Vec3 e = impact.normal / norm(impact.normal);
  // The overlap stays below a third of a radius or so.
  impact.i.velocity += (*decades(-2, 0) - dot(impact.i.velocity - impact.j.velocity, e)) * e;
  return impact;
}

double scale_of(const ObliqueImpact& impact) {
  const double spins =
      impact.i.radius * norm(impact.i.spin) + (impact.j.is_wall() ? 0 : impact.j.radius * norm(impact.j.spin));
  return norm(impact.i.velocity - impact.j.velocity) + spins;
}

/// Changes of the two bodies are equal, after the vectors of the first are turned by `image` and axial ones by `axial`.
template <class Image, class Axial>
void same(const ObliqueImpact& before, const ObliqueCollision& a, const ObliqueCollision& b, const Image& image,
          const Axial& axial) {
  RC_ASSERT(a.status == b.status);
  if (!a.separated()) return;
  const double slack = 1e-8 * scale_of(before);
  RC_ASSERT(norm(image(a.velocity_i) - b.velocity_i) <= slack);
  RC_ASSERT(norm(image(a.velocity_j) - b.velocity_j) <= slack);
  RC_ASSERT(norm(axial(a.spin_i) - b.spin_i) * before.i.radius <= slack);
  if (!before.j.is_wall()) RC_ASSERT(norm(axial(a.spin_j) - b.spin_j) * before.j.radius <= slack);
  RC_ASSERT(std::abs(a.lost.sum() - b.lost.sum()) <= 1e-8 * energy(before));
}

const auto unchanged = [](Vec3 a) { return a; };

}  // namespace

TEST_CASE("energy is never gained, every loss is one, and together they are what is missing") {
  CHECK(rc::check([] {
    const ObliqueImpact impact = any_impact();
    const auto out = collide(any_law(), any_tangential(), impact,
                             {.arm = *rc::gen::element(ContactArm::radius, ContactArm::contact_point)});
    RC_ASSERT(out.separated());
    const double before = energy(impact), left = energy(after(impact, out)), slack = 1e-9 * before;
    RC_ASSERT(std::abs(before - left - out.lost.sum()) <= slack);
    for (const double loss :
         {out.lost.normal, out.lost.dashpot, out.lost.sliding, out.lost.torsion, out.lost.rolling, out.lost.stored})
      RC_ASSERT(loss >= -slack);
    RC_ASSERT(std::abs(out.slip_time + out.stick_time - out.normal.tcol) <= 1e-9 * out.normal.tcol);
  }));
}

TEST_CASE("momentum and the angular momentum about the contact are conserved") {
  CHECK(rc::check([] {
    const ObliqueImpact impact = any_impact();
    const auto out = collide(any_law(), any_tangential(), impact);
    RC_ASSERT(out.separated());
    const ObliqueImpact later = after(impact, out);
    const Vec3 e = impact.normal / norm(impact.normal);
    // About the contact point, a radius from either centre.
    const auto angular = [&](const ObliqueImpact& o) {
      Vec3 sum = cross(-o.i.radius * e, o.i.mass * o.i.velocity) + inertia(o.i) * o.i.spin;
      if (!o.j.is_wall()) sum += cross(o.j.radius * e, o.j.mass * o.j.velocity) + inertia(o.j) * o.j.spin;
      return sum;
    };
    const double slack = 1e-12 * impact.i.mass * 10 * scale_of(impact);
    if (!impact.j.is_wall()) {
      RC_ASSERT(norm(impact.i.mass * (out.velocity_i - impact.i.velocity) +
                     impact.j.mass * (out.velocity_j - impact.j.velocity)) <= 10 * slack);
      RC_ASSERT(norm(angular(later) - angular(impact)) <= 1000 * slack);
    } else {
      RC_ASSERT(norm(impact.i.mass * (out.velocity_i - impact.i.velocity) - out.impulse) <= 10 * slack);
    }
  }));
}

TEST_CASE("a moving frame changes nothing, nor does turning or mirroring space") {
  CHECK(rc::check([] {
    const AnyLaw law = any_law();
    const TangentialContact contact = any_tangential();
    const ObliqueImpact impact = any_impact();
    const auto here = collide(law, contact, impact);
    ObliqueImpact moving = impact;
    const Vec3 boost = any_vector(3);
    moving.i.velocity += boost, moving.j.velocity += boost;
    same(
        impact, here, collide(law, contact, moving), [&](Vec3 v) { return v + boost; }, unchanged);

    // A half turn about a skew axis n: 2n(n·a) − a. A mirror at the plane of n: a − 2n(n·a), spins being axial.
    Vec3 n = any_vector(1);
    if (norm(n) < 0.1) n = {0, 1, 0};
    n = n / norm(n);
    const auto turn = [=](Vec3 a) { return 2 * dot(n, a) * n - a; };
    const auto mirror = [=](Vec3 a) { return a - 2 * dot(n, a) * n; };
    const auto image = [&](const auto& map, const auto& axial) {
      ObliqueImpact other = impact;
      other.normal = map(impact.normal);
      for (auto [from, to] : {std::pair{&impact.i, &other.i}, {&impact.j, &other.j}})
        to->velocity = map(from->velocity), to->spin = axial(from->spin);
      return other;
    };
    same(impact, here, collide(law, contact, image(turn, turn)), turn, turn);
    same(impact, here, collide(law, contact, image(mirror, turn)), mirror, turn);
  }));
}

TEST_CASE("it does not matter which body is called the first") {
  CHECK(rc::check([] {
    const AnyLaw law = any_law();
    const TangentialContact contact = any_tangential();
    ObliqueImpact impact = any_impact();
    if (impact.j.is_wall()) return;
    const ObliqueCollision here = collide(law, contact, impact);
    ObliqueCollision there = collide(law, contact, {-impact.normal, impact.j, impact.i});
    std::swap(there.velocity_i, there.velocity_j);
    std::swap(there.spin_i, there.spin_j);
    same(impact, here, there, unchanged, unchanged);
  }));
}

TEST_CASE("where nothing is lost the way back is the way, reversed") {
  // An elastic normal law, and a spring that has swung to its rest as the contact ends (β₀ = 1).
  CHECK(rc::check([] {
    const ObliqueImpact impact = any_impact();
    const double mass = 1 / (1 / impact.i.mass + 1 / impact.j.mass);
    const TangentialContact contact{tangential_for(1, collide(Linear(1, 0), {1, mass}).tcol, mass),
                                    Friction(1e9, 1e9, 0)};
    const auto reversed = [](ObliqueImpact o) {
      for (ImpactBody* b : {&o.i, &o.j}) b->velocity = -b->velocity, b->spin = -b->spin;
      return o;
    };
    const auto there = collide(Linear(1, 0), contact, impact);
    const ObliqueImpact way_back = reversed(after(impact, there));
    const auto back = collide(Linear(1, 0), contact, way_back);
    const ObliqueImpact again = reversed(after(way_back, back));
    const double slack = 1e-7 * scale_of(impact);
    RC_ASSERT(std::abs(energy(again) - energy(impact)) <= 1e-7 * energy(impact));
    RC_ASSERT(norm(again.i.velocity - impact.i.velocity) <= slack);
    RC_ASSERT(norm(again.i.spin - impact.i.spin) * impact.i.radius <= slack);
  }));
}
