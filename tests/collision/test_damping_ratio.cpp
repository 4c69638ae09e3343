#include <catch2/catch.hpp>

#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/peer_damping.hpp>

#include <numbers>
#include <set>
#include <string>

using namespace ricochet;

namespace {
constexpr double restitutions[] = {1e-6, 0.01, 0.05, 0.13, 0.1353, 0.14, 0.3, 0.5, 0.9, 0.99, 0.999999};

/// e_n of q'' + 2βq' + q = 0 ended where q + 2βq' = 0, from the real solution of each regime.
double force_ended(double beta) {
  const double root = std::sqrt(std::abs(1 - beta * beta));
  if (beta < 1) {
    double angle = std::atan(-2 * beta * root / (1 - 2 * beta * beta));  // tan(root t) at the first zero of q''
    if (angle < 0) angle += std::numbers::pi;
    return std::exp(-beta * angle / root);
  }
  return std::exp(-beta / root * std::log((beta + root) / (beta - root)));
}
}  // namespace

TEST_CASE("restitution and damping ratio are each other's inverse for both ends") {
  for (const double en : restitutions)
    for (const auto end : {ContactEnd::force, ContactEnd::overlap}) {
      const double beta = damping_of_restitution(en, end);
      CHECK(restitution_of_damping(beta, end) == Approx(en).epsilon(2e-14));
    }
  CHECK(damping_of_restitution(1, ContactEnd::force) == 0);
  CHECK(damping_of_restitution(1, ContactEnd::overlap) == 0);
  for (const auto end : {ContactEnd::force, ContactEnd::overlap})
    CHECK_FALSE(std::signbit(damping_of_restitution(1, end)));
}

TEST_CASE("small losses keep their relative digits") {
  // e_n = 1 − πβ + …, so β = δ/π for δ = 1 − e_n → 0; e_n itself carries δ to 1e-16/1e-9 only.
  const double en = 1 - std::ldexp(1.0, -30);
  for (const auto end : {ContactEnd::force, ContactEnd::overlap})
    CHECK(damping_of_restitution(en, end) * std::numbers::pi == Approx(std::ldexp(1.0, -30)).epsilon(2e-9));
}

TEST_CASE("the force end goes smoothly through critical damping") {
  for (const double beta : {0.2, 0.6, 0.8, 0.99, 1.01, 2.0, 30.0})
    CHECK(restitution_of_damping(beta, ContactEnd::force) == Approx(force_ended(beta)).epsilon(1e-12));
  CHECK(restitution_of_damping(1, ContactEnd::force) == Approx(std::exp(-2.0)).epsilon(1e-15));
}

TEST_CASE("damping ratios of the laws") {
  CHECK(damping_ratio(Linear(4, 6), 9) == Approx(0.5).epsilon(1e-15));
  CHECK(damping_ratio(Tsuji(4, 30), 45) == Approx(1).epsilon(1e-15));
}

TEST_CASE("misuse of the damping ratio is named") {
  CHECK_THROWS_AS(restitution_of_damping(1, ContactEnd::overlap), std::invalid_argument);
  CHECK_THROWS_AS(restitution_of_damping(-0.1, ContactEnd::force), std::invalid_argument);
  CHECK_THROWS_AS(damping_of_restitution(0, ContactEnd::force), std::invalid_argument);
  CHECK_THROWS_AS(damping_of_restitution(1.01, ContactEnd::overlap), std::invalid_argument);
  CHECK_THROWS_AS(damping_ratio(Linear(1, 1), 0), std::invalid_argument);
}

TEST_CASE("peer formulas that are exact for their law and end return what was asked") {
  std::set<std::string_view> ids;
  for (const PeerDamping& peer : peer_dampings()) {
    CAPTURE(std::string(peer.id));
    CHECK(ids.insert(peer.id).second);
    for (const double en : {0.05, 0.3, 0.5, 0.95}) {
      const double obtained = restitution_of_damping(peer.damping_ratio(en), peer.end);
      if (peer.exact)
        CHECK(obtained == Approx(en).epsilon(1e-14));
      else
        CHECK(std::abs(obtained - en) > 1e-6);
    }
  }
}

TEST_CASE("the peers' polynomials have the values of their printed coefficients") {
  CHECK(marshall_polynomial(0) == 1.2728);
  CHECK(marshall_polynomial(1) == Approx(0.0003).epsilon(1e-9));
  // The exponent's polynomial vanishes at e = 0, where γ diverges like 1/√(e(6.918798 − 2)).
  CHECK(thornton_polynomial(1e-8) * std::sqrt(1e-8 * 4.918798) == Approx(1).epsilon(1e-6));
  CHECK(thornton_polynomial(1e-300) * std::sqrt(1e-300 * 4.918798) == Approx(1).epsilon(1e-12));
}

TEST_CASE("Kuwabara and Kono's restitution by the form of Müller and Pöschel, and what it really is", "[peers]") {
  // u, exact e, and the form less it, from an independent integration.
  struct Known {
    double u, en, off;
  };
  for (const Known& k :
       {Known{0.4, 0.836034492, 1.6e-4}, Known{0.8, 0.525370938, 2.7e-3}, Known{2, 0.092999595, 8.4e-3}}) {
    CHECK(collide(KuwabaraKono(1, k.u * k.u), {1, 1}).en == Approx(k.en).epsilon(1e-8));
    CHECK(mueller_poeschel_restitution(k.u) - k.en == Approx(k.off).epsilon(0.04));
  }
  CHECK(mueller_poeschel_restitution(0) == 1);
}
