#include <catch2/catch.hpp>
#include <ricochet/ricochet.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace ricochet;

namespace {

double relative(double value, double reference) { return std::abs(value / reference - 1); }

/// Unit impact on a law with k = 1: c is then the dimensionless damping. Values to 20 digits from a Taylor integration
/// of the polynomial motion in 40-digit arithmetic.
struct Reference {
  double c;
  ContactEnd end;
  double tcol, en, overlap_end, max_overlap, time_max_overlap;
};

template <class Law>
void check_reference(const std::vector<Reference>& rows) {
  for (const auto& row : rows) {
    CAPTURE(row.c, row.end == ContactEnd::force);
    const auto out = collide(Law(1, row.c), {1, 1}, {row.end});
    REQUIRE(out.separated());
    CHECK(relative(out.tcol, row.tcol) < 1e-12);
    CHECK(relative(out.en, row.en) < 1e-12);
    CHECK(relative(out.max_overlap, row.max_overlap) < 1e-12);
    CHECK(relative(out.time_max_overlap, row.time_max_overlap) < 1e-12);
    CHECK(std::abs(out.overlap_end - row.overlap_end) < 1e-12);
    CHECK(out.max_force > 0);
    CHECK(out.time_max_force <= out.time_max_overlap * (1 + 1e-12));
  }
}

/// In ζ^{5/4} Tsuji's motion is a damped linear oscillator of damping ratio c/√5 (Antypov & Elliott, EPL 94, 50004
/// (2011)), whose restitution is a closed form.
double tsuji_en(double ratio, ContactEnd end) {
  const double sine = std::sqrt(std::abs(1 - ratio * ratio));
  const double psi = ratio < 1 ? std::acos(ratio) : std::acosh(ratio);
  return std::exp(-(end == ContactEnd::force ? 2 * psi : std::numbers::pi) * ratio / sine);
}

}  // namespace

TEST_CASE("Kuwabara-Kono: the collision matches 20-digit references") {
  check_reference<KuwabaraKono>({
      {0.1, ContactEnd::force, 3.1572556558025707066, 0.89285887550655333376, 0.089285887550655333376,
       1.0455967159180959053, 1.5813603317698664656},
      {0.1, ContactEnd::overlap, 3.2572898154307620369, 0.89214758729022934527, 0, 1.0455967159180959053,
       1.5813603317698664656},
      {1, ContactEnd::force, 2.7520265740390496633, 0.39393060322987319305, 0.39393060322987319305,
       0.76748080153903930767, 1.3948705057929498517},
      {1, ContactEnd::overlap, 3.8284546370222177772, 0.33116481046664093528, 0, 0.76748080153903930767,
       1.3948705057929498517},
      {4, ContactEnd::force, 2.1244681606637106246, 0.09299959494428642391, 0.37199837977714569564,
       0.4440961667357961426, 1.089151937493751948},
      {4, ContactEnd::overlap, 13.807319829618584695, 0.0050369302968274401183, 0, 0.4440961667357961426,
       1.089151937493751948},
  });
}

TEST_CASE("Tsuji: the collision matches 20-digit references") {
  check_reference<Tsuji>({
      {0.1, ContactEnd::force, 3.1032445456903483334, 0.87229146669070784611, 0.14207880614069186259,
       1.0352104676941003843, 1.5808912778135703614},
      {0.1, ContactEnd::overlap, 3.2663835304555163674, 0.86880462879691881613, 0, 1.0352104676941003843,
       1.5808912778135703614},
      {1, ContactEnd::force, 2.6455637053712679981, 0.33049996757673058217, 0.41241754906729086518,
       0.70215432243184960631, 1.3800690682738255732},
      {1, ContactEnd::overlap, 4.1367842330440915732, 0.20787957635076190855, 0, 0.70215432243184960631,
       1.3800690682738255732},
      {4, ContactEnd::force, 1.9688523172823448783, 0.057305128388959018519, 0.3077533470900612306,
       0.34837052350446162803, 1.0269739795439476623},
  });
}

TEST_CASE("Tsuji: the restitution is that of a linear oscillator in overlap^(5/4), at every damping") {
  for (const double ratio : {1e-6, 0.01, 0.3, 0.7, 0.9, 0.99, 1.1, 10.0, 500.0, 1e5, 1e20, 1e90}) {
    CAPTURE(ratio);
    for (const auto end : {ContactEnd::force, ContactEnd::overlap}) {
      if (ratio > 1 && end == ContactEnd::overlap) continue;
      const auto out = collide(Tsuji(1, ratio * std::sqrt(5.0)), {1, 1}, {end});
      REQUIRE(out.separated());
      CHECK(relative(out.en, tsuji_en(ratio, end)) < 1e-11);
    }
  }
}

TEST_CASE("Tsuji: an overdamped overlap never returns to zero but its force still ends") {
  const Tsuji law(1, 1.05 * std::sqrt(5.0));
  CHECK(collide(law, {1, 1}, {ContactEnd::overlap}).status == CollisionStatus::no_separation);
  CHECK(collide(law, {1, 1}, {ContactEnd::force}).status == CollisionStatus::ended_by_force);
}

TEST_CASE("Hertzian: the elastic contact has its known duration and greatest overlap") {
  // m v²/2 = (2/5) k ζ^{5/2}, and a duration of 2 ζ_max/v ∫₀¹ dx/√(1−x^{5/2}).
  const double deepest = std::pow(1.25, 0.4);
  const double share = std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
  for (const auto& out : {collide(KuwabaraKono(1, 0), {1, 1}), collide(Tsuji(1, 0), {1, 1})}) {
    CHECK(relative(out.en, 1) < 1e-13);
    CHECK(relative(out.max_overlap, deepest) < 1e-13);
    CHECK(relative(out.tcol, 2 * deepest * share) < 1e-13);
    CHECK(relative(out.max_force, std::pow(deepest, 1.5)) < 1e-13);
  }
}

TEST_CASE("a collision reports a spent budget and refuses what it cannot do") {
  CHECK(collide(Tsuji(1, 1), {1, 1}, {ContactEnd::force, CollideMethod::automatic, 20}).status ==
        CollisionStatus::budget_spent);
  CHECK_THROWS_WITH(collide(Tsuji(1, 1), {1, 1}, {ContactEnd::force, CollideMethod::closed_form}),
                    "method = closed_form: the Tsuji law has none");
  CHECK_THROWS_WITH(collide(Linear(1, 1), {-1, 1}), "velocity = -1: must be finite and > 0");
  CHECK_THROWS_WITH(collide(Linear(1, 1), {1, 0}), "mass_eff = 0: must be finite and > 0");
}
