// Any doubles to the oblique collision: an answer that is finite wherever it is called good, or the exception that the
// header names. The first bytes choose the laws, the rest are numbers.

#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/tangential_restitution.hpp>

#include "arguments.hpp"

#include <stdexcept>

using namespace ricochet;

namespace {

/// Half of them tame, so that inputs get past the first checks.
double number(Arguments& in, std::uint8_t how) { return how & 1 ? in.number() : in.share(); }

AnyLaw a_law(Arguments& in, std::uint8_t how) {
  const double p = number(in, how >> 3), q = number(in, how >> 4);
  switch (how % 5) {
    case 0: return Linear(p, q);
    case 1: return KuwabaraKono(p, q);
    case 2: return Tsuji(p, q);
    case 3: return Hysteretic(p, p + q);
    default: return Fractional(p, q, in.share());
  }
}

TangentialContact a_contact(Arguments& in, std::uint8_t how) {
  TangentialContact contact;
  const double k = number(in, how >> 2), c = number(in, how >> 3);
  if (how % 3 == 1) contact.law = LinearTangential(k, c);
  if (how % 3 == 2) contact.law = MindlinTangential(k, c);
  const double mu = number(in, how >> 4);
  contact.friction = Friction(mu, mu * in.share(), number(in, how >> 5), how & 64 ? in.share() : 0);
  if (how & 128) {
    contact.torsion = {how & 32 ? Torsion::Limit::disc : Torsion::Limit::separate, {in.share(), in.share()}};
    contact.rolling = {in.share(), {in.share(), in.share()}};
  }
  return contact;
}

ImpactBody a_body(Arguments& in, std::uint8_t how) {
  const auto vector = [&] { return Vec3{number(in, how), number(in, how), number(in, how)}; };
  return {number(in, how), number(in, how >> 1), vector(), vector(), number(in, how >> 2)};
}

void run(Arguments& in) {
  const std::uint8_t how = in.byte();
  const AnyLaw law = a_law(in, in.byte());
  const TangentialContact contact = a_contact(in, in.byte());
  ObliqueImpact impact{.normal = {number(in, how), number(in, how), number(in, how)}, .i = a_body(in, in.byte())};
  if (how & 2) impact.j = a_body(in, in.byte());
  if (how & 4) impact.i.velocity += 2 * impact.normal;
  const ObliqueOptions options{how & 8 ? ContactEnd::overlap : ContactEnd::force,
                               how & 16 ? ContactArm::contact_point : ContactArm::radius, 20'000};
  const ObliqueCollision out = collide(law, contact, impact, options);
  if (!out.separated()) return;
  for (const Vec3 v : {out.velocity_i, out.spin_i, out.spin_j, out.impulse}) expect_finite({v.x, v.y, v.z});
  expect_finite({out.normal.en, out.stick_time, out.slip_time, out.lost.sum(), out.impulse_ratio, out.et.value_or(0),
                 out.beta.value_or(0)});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Arguments in(data, size);
  try {
    run(in);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
