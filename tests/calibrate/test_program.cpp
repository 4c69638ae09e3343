// What the program makes of a command line and of files, against what the same asks of the library.
#include "console/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/csv.hpp>
#include <job.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <target_rows.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

Job job_from(std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  CLI::App app("tested", "calibrate");
  Options options;
  add_options(app, options);
  app.parse(words);
  return job_of(options);
}

double mass(double radius, double density) { return 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) * density; }

/// The rows that --targets makes of a file.
std::string answered(const std::string& file) {
  const TemporaryFolder folder;
  const std::string path = folder / "targets.csv";
  std::ofstream(path) << file;
  console::LineBlocks source(path, 1 << 16);
  console::LineBlocks::Block block;
  const auto head = console::take_csv_head(source, block);
  static const DirectCalibrator calibrator;
  const TargetRows rows("targets.csv", *head, TargetDefaults{}, calibrator);
  return rows.header() + rows.answer(block).text;
}

/// Of a table's one row.
double column(const std::string& csv, const std::string& name) {
  const auto fields = [](std::string line) {
    std::vector<std::string> all;
    for (std::size_t end = 0; end != std::string::npos; line.erase(0, end + 1)) {
      end = line.find(',');
      all.push_back(line.substr(0, end));
      if (end == std::string::npos) break;
    }
    return all;
  };
  const std::size_t end = csv.find('\n');
  const auto names = fields(csv.substr(0, end)),
             values = fields(csv.substr(end + 1, csv.find('\n', end + 1) - end - 1));
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k].rfind(name, 0) == 0) return std::stod(values.at(k));
  FAIL("no column " << name << " in " << csv);
  return 0;
}

}  // namespace

TEST_CASE("unequal spheres have the effective mass and radius of both") {
  const double r1 = 0.001, r2 = 0.003, m1 = mass(r1, 2500), m2 = mass(r2, 1200);
  const Job job = job_from({"--young", "70e9", "--poisson", "0.3", "--en", "0.8", "--law", "tsuji", "--radius", "0.001",
                            "--density", "2500", "--radius2", "0.003", "--density2", "1200"});
  CHECK(job.known.impact.mass_eff == Approx(m1 * m2 / (m1 + m2)).epsilon(1e-14));
  CHECK(job.radius_eff.value() == Approx(r1 * r2 / (r1 + r2)).epsilon(1e-14));
  CHECK(std::get<scale::Moduli>(job.known.scale).radius_eff == Approx(r1 * r2 / (r1 + r2)).epsilon(1e-14));
  const Job wall = job_from({"--tcol", "1e-4", "--en", "0.8", "--radius", "0.001", "--density", "2500", "--wall"});
  CHECK(wall.known.impact.mass_eff == Approx(m1).epsilon(1e-14));
  CHECK(wall.radius_eff.value() == Approx(r1).epsilon(1e-14));
}

TEST_CASE("a stiffness beside a collision time is the k that the fractional law of a row holds") {
  const std::string head = "tcol,en,law,stiffness\n1e-4,0.5,fractional,";
  for (const double k : {4000.0, 9000.0}) {
    const std::string answer = answered(head + std::to_string(k) + "\n");
    CHECK(column(answer, "k") == Approx(k).epsilon(1e-12));
    // c^α k^(1−α) is what t_col fixes: another k, another c.
    const double alpha = conversion_degree(0.5);
    CHECK(std::pow(column(answer, "c"), alpha) * std::pow(k, 1 - alpha) ==
          Approx(std::pow(0.2964394, alpha) * std::pow(5225, 1 - alpha)).epsilon(1e-6));
  }
}

TEST_CASE("words that a spreadsheet would run do not come out of a file of targets") {
  for (const std::string word : {"=cmd()", "+1", "-x", "@sum", "\x1b[2J"}) {
    const std::string answer = answered("tcol,en,law\n1e-4,0.5," + word + "\n");
    CHECK(answer.find("," + word) == std::string::npos);
    CHECK(answer.find(",,,\"bad input: law = ") != std::string::npos);
  }
  CHECK(answered("tcol,en,law\n1e-4,0.5,steel\n").find(",steel,") != std::string::npos);
}
