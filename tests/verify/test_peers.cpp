#include <catch2/catch.hpp>

#include <verify/registry.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

using namespace ricochet;
using namespace ricochet::verify;
using std::numbers::pi;

namespace {

StudyResult peers() {
  const auto studies = all_studies();
  const auto study = std::find_if(studies.begin(), studies.end(), [](const auto& s) { return s->name() == "peers"; });
  REQUIRE(study != studies.end());
  return (*study)->run({});
}

double obtained(const StudyResult& result, const std::string& peer, double asked) {
  for (const auto& row : result.rows)
    if (row["peer"] == peer && row["en_asked"] == asked) return row["en_obtained"];
  FAIL("no row of " << peer);
  return 0;
}

/// exp(−πβ/√(1−β²)): contact ended by overlap.
double by_overlap(double beta) { return std::exp(-pi * beta / std::sqrt(1 - beta * beta)); }

}  // namespace

TEST_CASE("verify peers: figures worked out by hand from the engines' formulas") {
  const StudyResult result = peers();
  CHECK(all_pass(result.gates));

  // LAMMPS's polynomial at 0.5, term by term, as c/√(mk) of the pair and, since 2026, times √2.
  const double alpha = 1.2728 - 4.2783 / 2 + 11.087 / 4 - 22.348 / 8 + 27.467 / 16 - 18.022 / 32 + 4.8218 / 64;
  CHECK(obtained(result, "lammps tsuji 2021", 0.5) == Approx(by_overlap(alpha / std::sqrt(5))).epsilon(1e-10));
  CHECK(obtained(result, "lammps tsuji 2026", 0.5) == Approx(by_overlap(alpha * std::sqrt(0.4))).epsilon(1e-10));
  // MFiX's factor 2 in place of √5.
  const double beta = std::log(2) / std::hypot(pi, std::log(2));
  CHECK(obtained(result, "mfix hertz 21", 0.5) == Approx(by_overlap(2 * beta / std::sqrt(5))).epsilon(1e-10));
  // A clipped linear contact stops at the angle π − 2 asin β of the damped oscillation.
  const double clipped = std::exp(-beta / std::sqrt(1 - beta * beta) * (pi - 2 * std::asin(beta)));
  for (const char* peer : {"yade tc-en", "liggghts hooke, limited", "liggghts hertz, limited", "lammps hertz, limited"})
    CHECK(obtained(result, peer, 0.5) == Approx(clipped).epsilon(1e-10));
}

TEST_CASE("verify peers covers 0.05 to 0.99 for every peer, and names where it read") {
  const StudyResult result = peers();
  std::set<std::string> ids;
  // The Padé form has rows at a few groups of its own.
  const std::string form = "mueller-poeschel 2011";
  std::size_t asked = 0, of_form = 0;
  double greatest = 0;
  for (const auto& row : result.rows) {
    CHECK(row["en_asked"].get<double>() + row["error"].get<double>() ==
          Approx(row["en_obtained"].get<double>()).epsilon(1e-15).margin(1e-16));
    if (row["peer"] == form) {
      ++of_form;
      continue;
    }
    ++asked;
    ids.insert(row["peer"].get<std::string>());
    greatest = std::max(greatest, row["en_asked"].get<double>());
  }
  CHECK(of_form >= 3);
  CHECK(asked == ids.size() * 95);
  CHECK(ids.size() >= 15);
  CHECK(result.rows.front()["en_asked"] == 0.05);
  CHECK(greatest == 0.99);
  CHECK(result.tables.back().rows().size() == ids.size());
}
