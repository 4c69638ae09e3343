// What the program makes of a command line and of files, against what the same asks of the library.
#include "calibrate/job_from.hpp"
#include "console/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/csv.hpp>
#include <fit_run.hpp>
#include <materials.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <report.hpp>
#include <target_rows.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

double mass(double radius, double density) { return 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) * density; }

/// The rows that --targets makes of a file, beside what its flags say of all.
std::string answered(const std::string& file, const TargetDefaults& defaults = {}) {
  const TemporaryFolder folder;
  const std::string path = folder / "targets.csv";
  std::ofstream(path) << file;
  console::LineBlocks source(path, 1 << 16);
  console::LineBlocks::Block block;
  const auto head = console::take_csv_head(source, block);
  static const DirectCalibrator calibrator;
  const TargetRows rows("targets.csv", *head, defaults, calibrator);
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

TEST_CASE(
    "a stiffness beside a collision time, of the row or of all, is the k that the fractional law of a row holds") {
  const std::string head = "tcol,en,law,stiffness\n1e-4,0.5,fractional,";
  for (const double k : {4000.0, 9000.0}) {
    TargetDefaults flag;
    flag.asked.stiffness = k;
    for (const std::string& answer : {answered(head + std::to_string(k) + "\n"), answered(head + "\n", flag),
                                      answered("tcol,en,law\n1e-4,0.5,fractional\n", flag)}) {
      CHECK(column(answer, "k") == Approx(k).epsilon(1e-12));
      // c^α k^(1−α) is what t_col fixes: another k, another c.
      const double alpha = conversion_degree(0.5);
      CHECK(std::pow(column(answer, "c"), alpha) * std::pow(k, 1 - alpha) ==
            Approx(std::pow(0.2964394, alpha) * std::pow(5225, 1 - alpha)).epsilon(1e-6));
    }
  }
}

TEST_CASE("a row of the CSV has the overlaps and the force of its own law, each in its column") {
  const double v = 0.4, m = 7e-6;
  const auto row = [&](const std::string& end) {
    const Job job = job_from(
        {"--tcol", "1e-4", "--en", "0.8", "--law", "linear", "--end", end, "--velocity", "0.4", "--mass-eff", "7e-6"});
    const Report report = calibration::run(job, {});
    return std::pair(std::get<Linear>(report.results.at(0).law), csv_of(report).csv());
  };
  for (const std::string end : {"force", "overlap"}) {
    CAPTURE(end);
    const auto [law, csv] = row(end);
    // ζ = (v/ω) e^(−γt) sin ωt with γ = ω₀ sin β, ω = ω₀ cos β; the force is m v ω₀/cos β e^(−γt) sin(ωt + 2β).
    const double natural = std::sqrt(law.k() / m), beta = std::asin(law.c() / (2 * std::sqrt(law.k() * m)));
    const double quarter = std::numbers::pi / 2;
    CHECK(column(csv, "max_overlap [m]") ==
          Approx(v / natural * std::exp(-std::tan(beta) * (quarter - beta))).epsilon(1e-9));
    CHECK(column(csv, "max_force [N]") ==
          Approx(m * v * natural * std::exp(-std::tan(beta) * (quarter - 3 * beta))).epsilon(1e-9));
    // No force is left where the spring's is the dashpot's.
    CHECK(column(csv, "overlap_end [m]") ==
          Approx(end == "force" ? law.c() * 0.8 * v / law.k() : 0).epsilon(1e-9).margin(1e-15));
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

TEST_CASE("the bodies of a fit are those of its rows, two equal spheres or one on a wall") {
  const double radius = 2e-3, density = 2500;
  for (const bool wall : {true, false}) {
    const double share = wall ? 1 : 0.5;
    std::vector<Measurement> data;
    for (const double v : {0.1, 0.3, 1.0})
      data.push_back({.velocity = v,
                      .en = 0.8,
                      .en_sigma = 0.01,
                      .tcol = 1e-4,
                      .tcol_sigma = 1e-6,
                      .mass_eff = share * mass(radius, density),
                      .radius_eff = share * radius});
    Options options;
    options.asked.wall = wall;
    const FitRequest request{.law = kind_of<Linear>, .mass_eff = data[0].mass_eff, .radius_eff = data[0].radius_eff};
    const auto report = run_of_fits(options, {fit_law(request, data)}, data);
    REQUIRE(report);
    CAPTURE(wall);
    CHECK(report->job.known.impact.mass_eff == Approx(share * mass(radius, density)).epsilon(1e-12));
    CHECK(report->job.radius_eff.value() == Approx(share * radius).epsilon(1e-12));
    CHECK(report->job.density.value() == Approx(density).epsilon(1e-12));
    CHECK(report->job.known.impact.velocity == 0.3);
  }
}

TEST_CASE("a file of materials: a pair's own time before that of all, and what a linear spring shares with Hertz's") {
  const auto read = [](const std::string& more, const std::string& materials, const std::string& pairs) {
    return read_materials("m.json", "{\"law\": {\"name\": \"linear\"}, \"velocity\": 0.4, " + more +
                                        "\"materials\": {" + materials + "}, \"pairs\": [" + pairs + "]}");
  };
  const std::string grain = R"("a": {"density": 2500, "radius": 2e-3})", plate = R"("w": {"wall": true})";
  const Materials timed = read("\"tcol\": 1e-4, ", grain + ", " + plate,
                               R"({"between": ["a", "a"], "en": 0.5}, {"between": ["w", "a"], "en": 1, "tcol": 2e-4})");
  CHECK(timed.pairs.at(0).tcol == 1e-4);
  CHECK(timed.pairs.at(1).tcol == 2e-4);

  // Without loss: Hertz's greatest overlap (5 m v²/(4 K))^{2/5}, K = (4/3) E* √R, and his time 2.94 of it over v.
  const double young = 1e7, poisson = 0.3, v = 0.4, m = mass(2e-3, 2500) / 2;
  const double stiffness = 4.0 / 3 * young / (2 * (1 - poisson * poisson)) * std::sqrt(1e-3);
  const double overlap = std::pow(5 * m * v * v / (4 * stiffness), 0.4);
  const double time = 2 * 0.4 * std::beta(0.4, 0.5) * overlap / v;
  for (const std::string match : {"time", "overlap"}) {
    const Materials solids = read("\"match\": \"" + match + "\", ",
                                  R"("a": {"density": 2500, "radius": 2e-3, "young": 1e7, "poisson": 0.3})",
                                  R"({"between": ["a", "a"], "en": 1})");
    const auto found = std::get<PairResult>(calibrate_pairs(solids).at(0));
    CAPTURE(match);
    if (match == "time") CHECK(found.found.achieved.tcol == Approx(time).epsilon(1e-9));
    if (match == "overlap") CHECK(found.found.achieved.max_overlap == Approx(overlap).epsilon(1e-9));
  }
}
