// What `verify column` says of shares that are known, and its smallest columns.
#include "../../verify/studies/column/claims.hpp"
#include "../../verify/studies/column/figures.hpp"
#include "../../verify/studies/column/proofs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::column;

namespace {

/// 0.02 nc of the energy in single collisions, of which every law takes a half; of one law nothing is known at 3.
Shares half_of_it() {
  Shares shares;
  for (std::size_t n = 1; n <= 20; ++n) shares.beads.push_back(n);
  const auto curve = [&](const std::string& id, double part) {
    ShareCurve c{id, {}};
    for (const std::size_t n : shares.beads) c.share.emplace_back(part * 0.02 * static_cast<double>(n));
    return c;
  };
  shares.curves.push_back(curve("event-driven", 1));
  for (const ColumnLaw& law : column_laws()) shares.curves.push_back(curve(law.id, 0.5));
  shares.curves.push_back(curve("fractional alpha=0.0258", 0.25));
  shares.curves.push_back(curve("fractional alpha(nc)", 1));
  shares.curves.back().share[2].reset();
  return shares;
}

double value_of(const std::vector<Gate>& gates, const std::string& name) {
  const auto found = std::find_if(gates.begin(), gates.end(), [&](const Gate& g) { return g.name == name; });
  REQUIRE(found != gates.end());
  return found->value;
}

}  // namespace

TEST_CASE("what a law leaves to the beads is the rest of the event-driven share, less the error of the steps") {
  std::vector<Gate> gates;
  const Shares shares = half_of_it();
  claim_gates(gates, shares, {.law = {0.03, 1, 1}, .points = {}});
  const double error = stated_error({}) / 0.02;  // a bead, of that part of the share
  for (const char* law : {"linear1", "tsuji", "fractional"}) {
    const std::string name = law;
    CHECK(value_of(gates, name + " detaches: least part of the event-driven share that it keeps, nc = 2 to 20") ==
          Approx(0.5 - error).epsilon(1e-12));
    CHECK(value_of(gates, name + " detaches ever more: that part at nc = 20 over that at nc = 2") ==
          Approx(1).epsilon(1e-12));
  }
  CHECK(value_of(gates, "linear1: more beads lose less, share at nc = 20 over nc = 1") == Approx(20));
  const std::string said = verdict(shares, {.law = {0.03, 1, 1}, .points = {}});
  CHECK(said.find("20 beads lose 0.400 of their energy in single collisions, but 0.200 to 0.200 under laws") == 0);
  CHECK(said.find("Constant alpha = 0.0258 stays within 0.100 of the hysteretic law.") != std::string::npos);
}

TEST_CASE("alpha(nc) begins at alpha(1), and with a = b = 1 is that of nc collisions one after the other") {
  const ConversionLaw law{0.03, 1, 1};
  CHECK(law(1) == Approx(0.03).epsilon(1e-14));
  CHECK(law(4) == Approx(1 - std::pow(0.97, 4)).epsilon(1e-14));
  CHECK(ConversionLaw{0.03, 0.5, 2}.exponent(3) == Approx(4).epsilon(1e-14));  // (1 + 0.5·2)²
}

TEST_CASE("shares and what is left of the energy are one together, where they are known") {
  const auto all = rows(half_of_it(), {});
  std::size_t known = 0;
  for (const auto& row : all) {
    if (row["share"].is_null()) {
      CHECK(row["energy_ratio"].is_null());
      CHECK(row["nc"] == 3);
      continue;
    }
    CHECK(row["share"].get<double>() + row["energy_ratio"].get<double>() == Approx(1).epsilon(1e-15));
    ++known;
  }
  CHECK(known == 20 * 9 - 1);
}

TEST_CASE("every curve of Fig. 6 is drawn from the column that has its name") {
  const Shares shares = half_of_it();
  const auto figure = share_figure(shares.beads, shares.curves);
  const std::string& csv = figure.data[0].bytes;
  const std::string script = console::script_of(figure.plot);
  CHECK(csv.starts_with("nc,event-driven,linear1,linear2,kuwabara-kono,tsuji,hysteretic,fractional,"));
  CHECK(csv.find("\n3,0.06,0.03,0.03,0.03,0.03,0.03,0.03,0.015,\n") != std::string::npos);
  CHECK(script.find("using 2:") == std::string::npos);
  CHECK(script.find("'column-share.csv' skip 1 using 1:2 with lines lw 2.5") != std::string::npos);
  for (const auto& [column, title] : {std::pair(3, "linear, ended by overlap"),
                                      {4, "linear, ended by force"},
                                      {5, "kuwabara-kono"},
                                      {6, "tsuji"},
                                      {9, "fractional, α = 0.0258"},
                                      {10, "fractional, α(n_c)"}}) {
    const auto at = script.rfind("using 1:" + std::to_string(column) + " with");
    REQUIRE(at != std::string::npos);
    const auto named = script.find("title '", at) + 7;
    CHECK(script.substr(named, std::string(title).size()) == title);
  }
}
