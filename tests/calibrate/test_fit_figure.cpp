// The figure of --figures: what is left over, and which columns are drawn.
#include <catch2/catch.hpp>
#include <fit_figure.hpp>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    // Names of curves have commas of their own, between quotes.
    static const std::regex field("\"[^\"]*\"|[^,]+");
    rows.emplace_back();
    for (std::sregex_iterator at(line.begin(), line.end(), field), end; at != end; ++at)
      rows.back().push_back(at->str());
  }
  return rows;
}

}  // namespace

TEST_CASE("the residuals of a fit are measured less fitted, in standard errors, and drawn from their own columns") {
  // Of a law whose e_n and t_col know no speed: the means 0.8 and 1e-4 s, as all weigh the same.
  const std::vector<Measurement> data{
      {0.1, 0.81, 0.01, 1.02e-4, 1e-6}, {0.3, 0.79, 0.01, 0.99e-4, 1e-6}, {1.0, 0.80, 0.01, 0.99e-4, 1e-6}};
  std::vector<Fit> fits;
  for (const LawKind law : {LawKind(kind_of<Linear>), LawKind(kind_of<Hysteretic>), LawKind(kind_of<KuwabaraKono>)})
    fits.push_back(fit_law({.law = law, .mass_eff = 7e-6}, data));
  const console::Figure figure = figure_of(fits, data);
  const auto points = rows_of(figure.data.at(0).bytes);
  REQUIRE(points.size() == 4);
  // Two curves: linear and hysteretic say the same.
  REQUIRE(points[0].size() == 9);
  CHECK(points[0][5].find("linear; hysteretic") != std::string::npos);
  CHECK(points[0][7].find("kuwabara-kono") != std::string::npos);
  const double en[] = {1, -1, 0}, tcol[] = {2, -1, -1};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::stod(points[i + 1][5]) == Approx(en[i]).margin(0.01));
    CHECK(std::stod(points[i + 1][6]) == Approx(tcol[i]).margin(0.01));
  }
  // Below, e_n left and t_col right, a curve each: its column of either.
  std::set<std::string> drawn;
  const std::regex residual("'fit_points.csv' skip 1 using 1:(\\d+) with points pt 7 ps 0.7");
  const std::string script = console::script_of(figure.plot);
  for (std::sregex_iterator at(script.begin(), script.end(), residual), end; at != end; ++at)
    drawn.insert(points[0].at(std::stoul((*at)[1].str()) - 1));
  CHECK(drawn == std::set<std::string>(points[0].begin() + 5, points[0].end()));
  const auto lines = rows_of(figure.data.at(1).bytes);
  CHECK(lines.size() == 102);
  CHECK(std::stod(lines[1][1]) == Approx(fits[0].predictions[0].en).epsilon(1e-12));
  CHECK(std::stod(lines.back()[0]) == Approx(1).epsilon(1e-12));
}
