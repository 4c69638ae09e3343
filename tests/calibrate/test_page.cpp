// What the page of --report says, against closed forms and the laws' own numbers.
#include "calibrate/job_from.hpp"

#include <console/html.hpp>

#include <catch2/catch.hpp>
#include <report.hpp>
#include <ricochet/contact/tangential.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

/// The text of the part between two places of the page, a space for every tag.
std::string text_between(const std::string& page, const std::string& from, const std::string& to) {
  const auto at = page.find(from);
  REQUIRE(at != std::string::npos);
  return std::regex_replace(page.substr(at, page.find(to, at) - at), std::regex("(<[^>]*>|\\s)+"), " ");
}

/// The numbers that follow the words, in the order in which they stand.
std::vector<double> numbers_after(const std::string& text, const std::string& words, std::size_t count) {
  auto at = text.find(words);
  REQUIRE(at != std::string::npos);
  at += words.size();
  std::vector<double> numbers;
  for (std::size_t used = 0; numbers.size() < count; at += used) numbers.push_back(std::stod(text.substr(at), &used));
  return numbers;
}

/// Where the words stand; a page without them fails.
std::size_t place(const std::string& page, const std::string& words) {
  const auto at = page.find(words);
  INFO(words);
  REQUIRE(at != std::string::npos);
  return at;
}

std::size_t count(const std::string& page, const std::string& words) {
  std::size_t n = 0;
  for (auto at = page.find(words); at != std::string::npos; at = page.find(words, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("the page begins with what it is, the collision and the command that makes it") {
  const Report report =
      run(job_from({"--tcol", "1e-4", "--en", "0.5", "--law", "fractional"}), {.method = Method::direct});
  const std::string page = page_of(report, {.command = "calibrate --en 0.5 <it>"});
  CHECK(place(page, "<title>Contact laws calibrated for tcol = 1e-04 s, en = 0.5</title>") > 0);
  const auto heading = place(page, "<h1>Contact laws calibrated for <i>t</i><sub>col</sub> = 10<sup>−4</sup> s,"),
             lead = place(page, "<p class=\"lead\">Computed, at 0.5 m/s"), figure = place(page, "<figure>"),
             command = place(page, "<code id=\"command\">calibrate --en 0.5 &lt;it&gt;</code>"),
             rest = place(page, "<h2");
  CHECK(heading < lead);
  CHECK(lead < figure);
  CHECK(figure < command);
  CHECK(command < rest);
  CHECK(page.find("measured") == std::string::npos);
  const Report given = run(job_from({"--law", "linear", "--with", "k=5000,c=0.1"}), {});
  CHECK(place(page_of(given, {.command = "x"}), "<title>What the law linear with k = 5000 kg/s^2, c = 0.1 kg/s does") >
        0);
}

TEST_CASE("the page of a fit begins with the fit, and has the collision further down") {
  const Report report = run(job_from({"--tcol", "1e-4", "--en", "0.5", "--law", "linear"}), {.method = Method::direct});
  const std::string page = page_of(
      report, {.command = "x", .heading = "Laws by a fit", .figure = "<figure>F</figure>", .section = "<p>S</p>"});
  CHECK(place(page, "<h1>Laws by a fit</h1>") < place(page, "<figure>F</figure>"));
  CHECK(place(page, "<figure>F</figure>") < place(page, "<h2 id=\"fit\">"));
  CHECK(place(page, "<h2 id=\"fit\">") < place(page, "<h2 id=\"curves\">The collision</h2>\n<figure>"));
  CHECK(place(page, "<li><a href=\"#fit\">") < place(page, "<li><a href=\"#curves\">"));
}

TEST_CASE("the page copies each law for each engine that has it, by the driver where it needs one, and says why not") {
  const Report report = run(job_from({"--tcol", "1e-4", "--en", "0.5"}), {.method = Method::direct});
  const std::string page = page_of(report, {.command = "calibrate"});
  std::size_t written = 0;
  for (std::size_t i = 0; i < report.results.size(); ++i)
    for (const Engine engine : engines()) {
      const auto snippet = snippet_of(report, i, engine);
      REQUIRE(snippet);
      const Calibration& r = report.results[i];
      const std::string id =
          std::string(text(engine)) + "-" + std::string(name(r.law)) + "-" + std::string(text(r.end));
      INFO(id);
      const bool there = snippet->fidelity != Fidelity::absent;
      written += there;
      // In the table, and at the text itself.
      CHECK(count(page, "data-copy=\"" + id + "\"") == (there ? 2u : 0u));
      CHECK(count(page, "<code id=\"" + id + "\">") == (there ? 1u : 0u));
      CHECK(count(page, "<a href=\"#" + id + "\">") == (there ? 1u : 0u));
      if (!there) CHECK(place(page, console::html_text(why_absent(*snippet)) + ".</p>") > 0);
    }
  CHECK(written > 20);
  CHECK(place(page, "<summary>fractional, ended by force: exact by liggghts-ricochet</summary>") > 0);
  CHECK(place(page, "<summary>fractional-zener, ended by force: exact by lammps-ricochet</summary>") > 0);
  CHECK(place(page, "<summary>linear, ended by overlap: exact </summary>") > 0);
  const std::string steps = text_between(page, ">Time step that keeps", "</table>");
  CHECK(place(steps, "fractional force liggghts-ricochet, lammps-ricochet 5e-06 20") > 0);
}

TEST_CASE("the page says what one percent of k and c does to a linear contact, and whose force is greatest") {
  const Report report = run(job_from({"--tcol", "1e-4", "--en", "0.5", "--law", "linear"}), {.method = Method::direct});
  REQUIRE(report.results.size() == 2);
  const std::string page = page_of(report, {.command = "calibrate"});
  const std::string table = text_between(page, "id=\"sensitivities\"", "id=\"data\"");
  // Ended by overlap: ln e = −πβ/√(1−β²), t = π/√(k/m (1−β²)), β ∝ c/√k.
  const double loss = -std::log(0.5), pi = std::numbers::pi, beta2 = loss * loss / (pi * pi + loss * loss);
  const double of_k = loss / (2 * (1 - beta2)), time_of_c = beta2 / (1 - beta2), time_of_k = -0.5 - 0.5 * time_of_c;
  const auto k = numbers_after(table, "linear overlap k", 2), c = numbers_after(table, "linear overlap c", 2);
  CHECK(k[0] == Approx(time_of_k).margin(5e-4));
  CHECK(k[1] == Approx(of_k).margin(5e-4));
  CHECK(c[0] == Approx(time_of_c).margin(5e-4));
  CHECK(c[1] == Approx(-2 * of_k).margin(5e-4));
  // A damped spring that is let go before it attracts is the softer one, as it has the same time.
  const auto forces = [&](std::size_t i) { return report.results[i].achieved.max_force; };
  REQUIRE(report.results[0].end == ContactEnd::overlap);
  CHECK(forces(1) < forces(0));
  CHECK(page.find("ranges from 0.0778 N (linear, ended by force) to 0.0928 N (linear, ended by overlap)") !=
        std::string::npos);
  CHECK(forces(0) == Approx(0.0928).margin(5e-5));
  CHECK(forces(1) == Approx(0.0778).margin(5e-5));
}

TEST_CASE("the page says of oblique impacts what sticking and sliding leave") {
  const double mu = 0.3, en = 0.7, beta0 = 0.5, degree = std::numbers::pi / 180;
  const Report report = run(
      job_from({"--tcol", "1e-4", "--en", "0.7", "--law", "linear", "--end", "force", "--beta0", "0.5", "--mu", "0.3"}),
      {.method = Method::direct});
  const std::string page = page_of(report, {.command = "calibrate"});
  const std::string table = text_between(page, "id=\"oblique-sensitivities\"", "id=\"data\"");
  // Where it sticks e_t = 1 − (2/7)(1 + β₀), where it slides 1 − μ(1 + e_n)/tan; of one percent more. At 5 degrees it
  // slides as it begins and ends, of which a percent is made.
  const auto steep = numbers_after(table, "β 0 μ 5", 4), flat = numbers_after(table, " 80", 4);
  CHECK(steep[2] == Approx(-0.01 * 2 / 7 * beta0).epsilon(0.01));
  CHECK(std::abs(steep[3]) <= 0.01 * std::abs(steep[2]));
  CHECK(std::abs(flat[2]) <= 2e-6);
  CHECK(flat[3] == Approx(-0.01 * mu * (1 + en) / std::tan(80 * degree)).margin(2e-6));
  CHECK(flat[1] == Approx(-0.01 * mu * en / std::tan(80 * degree)).margin(2e-6));
  const auto& rebounds = report.tangential.front().rebounds;
  const auto least = std::min_element(rebounds.begin(), rebounds.end(),
                                      [](const ObliqueRebound& a, const ObliqueRebound& b) { return a.et < b.et; });
  const auto said = numbers_after(page, "the centre keeps least of its tangential speed at", 1);
  CHECK(said[0] == Approx(least->angle / degree).epsilon(1e-9));
  CHECK(numbers_after(page, "tangential speed at " + std::to_string(std::lround(said[0])) + " degrees,", 1)[0] ==
        Approx(least->et).epsilon(1e-3));
}
