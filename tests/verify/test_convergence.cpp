#include "../../verify/studies/arms_motion.hpp"
#include "../../verify/studies/convergence.hpp"
#include "../../verify/studies/solvers.hpp"

#include <verify/registry.hpp>

#include <ricochet/collision/fractional_contact.hpp>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;

namespace {

/// The same operator with one weight wrong by a hundredth.
Operator broken(Operator op, std::size_t weight) {
  op.make = [make = op.make, weight](double alpha, double step, std::size_t steps) {
    const ConvolutionRule rule = make(alpha, step, steps);
    std::vector<double> w(rule.weights().begin(), rule.weights().end());
    w[weight] *= 1.01;
    return ConvolutionRule(w, {rule.first().begin(), rule.first().end()}, {rule.second().begin(), rule.second().end()});
  };
  return op;
}

bool all_green(const Operator& op, double alpha) { return all_pass(to_gates(measure(op, alpha))); }

}  // namespace

TEST_CASE("the convergence gates pass every operator as it is, and turn red for one wrong weight") {
  for (const Operator& op : fractional_operators()) {
    CAPTURE(op.name);
    CHECK(all_green(op, 0.25));
    CHECK_FALSE(all_green(broken(op, 1), 0.25));
    CHECK_FALSE(all_green(broken(op, 7), 0.25));
  }
}

TEST_CASE("an order is judged from both sides") {
  Convergence c{.statement = {"s", "f", 0.5, 2.0, 0.1}};
  const auto measured = [&](double order) {
    c.steps.clear(), c.errors.clear(), c.values.clear();
    for (int i = 0; i < 6; ++i) {
      c.steps.push_back(std::size_t{16} << i);
      c.errors.push_back(std::exp2(-order * i) * 1e-3);
      c.values.push_back(c.errors.back());
    }
    return c.pass();
  };
  CHECK(measured(2.05));
  CHECK_FALSE(measured(2.2));
  CHECK_FALSE(measured(1.8));
  CHECK(measured(1.95));
  CHECK(c.observed() == Approx(1.95));
  CHECK_FALSE(measured(std::nan("")));
  CHECK_FALSE(all_pass(to_gates({c})));
}

TEST_CASE("the extrapolated value and the grid convergence index belong to the stated order") {
  Convergence c{.statement = {"s", "f", 0.5, 2.0, 0.1},
                .steps = {1, 2, 4, 8},
                .errors = {64, 16, 4, 1},
                .values = {64, 16, 4, 1},
                .scale = 2};
  CHECK(c.richardson_error() == Approx(0).margin(1e-14));
  CHECK(c.grid_convergence_index() == Approx(1.25 * 3 / 3 / 2));
  CHECK(c.pass());
}

TEST_CASE("what is exact must be exact, and a NaN is never") {
  Convergence c{.statement = {"s", "f", 0.5, std::nullopt, 0.1},
                .steps = {1, 2},
                .errors = {1e-15, 1e-12},
                .values = {1e-15, 1e-12}};
  CHECK(all_pass(to_gates({c})));
  c.errors[0] = 1e-9;
  CHECK_FALSE(c.pass());
  CHECK_FALSE(all_pass(to_gates({c})));
  c.errors[0] = std::nan("");
  CHECK_FALSE(c.pass());
  CHECK_FALSE(all_pass(to_gates({c})));
}

TEST_CASE("verify orders: a mesh graded towards the start gives L1 and the trapezoid rule their orders back") {
  // t^{3/2} at α = 0.5: order 1 at all nodes of a uniform mesh; graded 2 − α = 1.5 of L1, 2 of the trapezoid rule.
  const auto studies = all_studies();
  const auto orders = std::find_if(studies.begin(), studies.end(), [](const auto& s) { return s->name() == "orders"; });
  REQUIRE(orders != studies.end());
  CLI::App app;
  (*orders)->add_options(app);
  std::vector<std::string> words{"--alpha", "0.5", "--steps", "64,128,256,512,1024"};
  for (const char* scheme :
       {"L1, uniform", "L1, graded", "trapezoid derivative, uniform", "trapezoid derivative, graded"})
    words.insert(words.end(), {"--scheme", scheme});
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  app.parse(words);
  const StudyResult result = (*orders)->run({.thorough = true});
  CHECK(result.gates.size() == 4);
  for (const Gate& gate : result.gates) {
    INFO(gate.name << " = " << gate.value);
    CHECK(gate.pass);
  }
  REQUIRE(result.rows.size() == 4);
  for (const auto& row : result.rows) {
    const std::string scheme = row["scheme"];
    const double full = scheme.starts_with("L1") ? 1.5 : 2;
    CHECK(row["stated_order"] == (scheme.ends_with("graded") ? full : 1.0));
  }
}

TEST_CASE("the exact motion under a kernel is a spring's, tends to the fractional law's, and is where solvers go") {
  const ArmsMotion spring = exact_motion(memory_kernel(0, 0.1, 10, 1e-6), 3);
  CHECK(spring.tcol == Approx(std::numbers::pi).epsilon(1e-14));
  CHECK(spring.en == Approx(1).epsilon(1e-14));
  CHECK(std::abs(spring.overlap_end) < 1e-14);
  for (const double alpha : {0.1, 0.5, 0.9}) {
    CAPTURE(alpha);
    const FractionalContact law = fractional_contact(alpha);
    const Fractional one(1, 1, alpha);
    const Impact impact{.velocity = 1, .mass_eff = 1};
    // The kernel errs by its tolerance and by delta^(3 - alpha).
    const double delta = law.tau / 1000, bound = 10 * (std::pow(delta, 3 - alpha) + 1e-10);
    const ArmsMotion fine = exact_motion(solver_kernel(one, impact, delta), law.tau);
    CHECK(fine.tcol == Approx(law.tau).epsilon(bound));
    CHECK(fine.en == Approx(law.en).epsilon(bound));
    CHECK(fine.overlap_end == Approx(law.overlap_end * law.tau).epsilon(bound));
    // Order 4 leaves 1e-11 of 1024 steps.
    const MemoryKernel coarse = solver_kernel(one, impact, law.tau / 16);
    const ArmsMotion kept = exact_motion(coarse, law.tau);
    FractionalSolverOptions options{.step = law.tau / 1024};
    options.kernel = coarse;
    const auto stepped = solve_collision(FractionalScheme::arms_rosenbrock, one, impact, options);
    CHECK(stepped.tcol == Approx(kept.tcol).epsilon(1e-9));
    CHECK(stepped.en == Approx(kept.en).epsilon(1e-9));
    CHECK(stepped.overlap_end == Approx(kept.overlap_end).epsilon(1e-9));
    CHECK(std::abs(kept.en / law.en - 1) > 1e-8);  // it is the kernel's, not the law's
  }
}

TEST_CASE("Rosenbrock's order is one towards the exact motion under its kernel, which a wrong arm would miss") {
  const SolverConvergence good =
      measure(FractionalScheme::arms_rosenbrock, 0.5, doubled_steps(128), Against::kept_kernel);
  CHECK(good.en.pass());
  CHECK(stated_against(FractionalScheme::arms_rosenbrock) == Against::kept_kernel);
  const SolverConvergence other =
      measure(FractionalScheme::arms_rosenbrock, 0.5, doubled_steps(128), Against::closed_form);
  CHECK_FALSE(other.en.pass());  // whose kernel keeps an error
}
