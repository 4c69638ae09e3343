#pragma once

#include "results.hpp"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::verify::conformance {

/// Ordered by how much is to be said against it.
enum class Verdict {
  exact,              ///< |d| ≤ f at every step
  converges,          ///< |L| ≤ u + f
  too_coarse,         ///< |L| ≤ u + f, but u > `least_known`: finer steps would tell
  elsewhere,          ///< |L| > u + f
  does_not_converge,  ///< does not settle, and u > `least_known`
  not_run             ///< fewer than `fewest_runs` runs, or two closer than `least_refinement`
};
std::string_view text(Verdict verdict) noexcept;

/// The extrapolation takes the differences of three pairs.
inline constexpr std::size_t fewest_runs = 4;
/// Steps closer than this tell next to nothing of where they go: of a first-order error that is off by e at the finest,
/// neighbours differ by no more than 0.4 e.
inline constexpr double least_refinement = 1.4;
/// What rounding may make of an end state over a run of some 10⁵ steps, as a share of the scale.
inline constexpr double rounding = 1e-10;
/// A limit that is not known to this share of the scale is none.
inline constexpr double least_known = 0.01;

/// Where values go as the step goes to 0.
struct Limit {
  double value = 0;
  double uncertainty = 0;
  bool smooth = false;   ///< extrapolated; else it is the finest value
  bool settles = false;  ///< the differences fall like an order above 1/3 does
};

/// Of values at the steps h, coarsest first, at least `fewest_runs`.
///
/// Smooth: Richardson's extrapolations of neighbours by first order, L₁, L₂, …, have differences D of which each of
/// the last two is at most 0.35 of the one before (of an error a h + b h² it is 1/4 as h is halved, of a h + b h^{3/2}
/// 0.354, of one that is irregular, a(h) h with any |a| ≤ K, about 1/2), or below `noise`. What is
/// then still to come is less than 0.35/(1 − 0.35) = 0.54 of the last difference if it goes on so; as two may fall so
/// by chance, the uncertainty is twice the last.
/// Otherwise the limit is the finest value, and errors of first order, |d(h) − L| ≤ K h, are off by K h there: K is
/// taken as twice the greatest |d(h) − d(finest)|/h.
/// Values that do not settle (the greater of the last two differences of neighbours, over h, exceeds 2.5 times the
/// greatest of those before: over two halvings that is an order below 1/3) are taken to wander on: the limit is known
/// to twice the greater of those two differences.
Limit limit_of(const std::vector<double>& h, const std::vector<double>& values, double noise);

/// One answer against what an engine gave. Errors are shares of the answer's scale.
struct Graded {
  Answer answer;
  std::vector<double> steps_in_scale = {}, error = {};
  Limit limit{};
  double floor = 0;                                         ///< f: to which the answer is known, and rounding
  double order = std::numeric_limits<double>::quiet_NaN();  ///< of the errors from the limit, or the answer
  double order_uncertainty = std::numeric_limits<double>::quiet_NaN();
  Verdict verdict = Verdict::not_run;
};

/// Energy at the end over that at the start.
struct EnergyBalance {
  double exact = 0, limit = 0, uncertainty = 0, coarsest = 0, finest = 0;
  /// More, or less, than the answer's in the limit, beyond what is uncertain.
  bool made() const noexcept { return limit - exact > uncertainty; }
  bool lost() const noexcept { return exact - limit > uncertainty; }
};

struct Cause {
  std::string what;       ///< in a sentence
  bool repeated = false;  ///< every run was repeated here to rounding
  double misfit = 0;      ///< greatest difference, shares of scale, at the runs or in the limit
};

struct CaseGrade {
  const Case* of = nullptr;
  Verdict verdict = Verdict::not_run;
  std::vector<Graded> answers = {};
  std::optional<EnergyBalance> energy = {};  ///< of cases without gravity
  std::vector<Cause> causes = {};            ///< the best first
  std::string note = {};                     ///< the engine's own, or why it was not graded

  /// The required answer that the verdict is from: the one farthest off; nullptr where there is none.
  const Graded* worst() const;
  /// Greatest error of required answers in the run; by index from the coarsest.
  double error_at(std::size_t run) const;
};

/// What is always the same of a case: computed once for all engines.
struct Answered {
  Case of;
  Solution solution;
  std::vector<Answer> answers;
};
std::vector<Answered> answered(const std::vector<Case>& cases);

/// `result`: nullptr where the engine's file does not have the case. Without causes.
CaseGrade grade(const Answered& answered, const CaseResult* result);

/// What an end state says of an asked number, `time` [s] after the touch.
double measured(const Case& of, const Run& run, const Asked& asked);

struct EngineGrade {
  Results results;
  std::vector<CaseGrade> cases;

  std::size_t count(Verdict verdict) const;
  std::size_t right() const { return count(Verdict::exact) + count(Verdict::converges); }
  std::size_t run() const { return cases.size() - count(Verdict::not_run); }
};

}  // namespace ricochet::verify::conformance
