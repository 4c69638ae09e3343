#pragma once

#include "results.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::verify::conformance {

/// Ordered by how much is to be said against it.
enum class Verdict {
  exact,         ///< |d| ≤ f at every step, f ≤ `least_known`
  converges,     ///< |L| ≤ u + f
  too_coarse,    ///< |L| ≤ u + f, but u or what digits leave > `least_known`: finer steps, more digits would tell
  another_rule,  ///< |L| > u + f, and L is what a known other rule for tangential springs gives (causes.hpp)
  elsewhere,     ///< |L| > u + f
  does_not_converge,  ///< does not settle, and u > `least_known`
  not_run             ///< fewer than `fewest_runs` runs, or two closer than `least_refinement`
};
inline constexpr std::array verdicts{Verdict::exact,        Verdict::converges, Verdict::too_coarse,
                                     Verdict::another_rule, Verdict::elsewhere, Verdict::does_not_converge,
                                     Verdict::not_run};
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

/// Of values at the steps h, coarsest first, at least `fewest_runs`. Changes below `floor` do not matter; each value
/// was rounded to ±`digits`.
///
/// Smooth: Richardson's extrapolations of neighbours by first order, L₁, L₂, …, have differences D of which each of the
/// last two is at most ρ times the one before, ρ = 0.35 as h is halved, 0.35^{log₂ r} as it is divided by r (of an
/// error a h + b h² it is 1/4, of a h + b h^{3/2} 0.354, of one that is irregular, a(h) h with any |a| ≤ K, about 1/2),
/// or below `floor`. The last D alone would not tell how far the last L is off: it may be small by chance, as two
/// errors that are alike differ by nothing, and so may the one before. So let E be the greatest of the last D, ρ times
/// the one before and ρ² times that before it. If L is nearer to the limit than one of the three L before it, as the
/// smooth errors above are, |e_n| ≤ ρ^k |e_{n−k}| for one k ≤ 3, then |L_n − L_{n−k}| ≥ (ρ^{−k} − 1) |e_n|. It is at
/// most D_n + … + D_{n−k+1} ≤ E (1 + ρ^{−1} + … + ρ^{1−k}) = E (ρ^{−k} − 1)/(ρ^{−1} − 1); hence |e_n| ≤ ρ/(1 − ρ) E,
/// 0.54 E as h is halved. The uncertainty is 2 E, 3.7 times as much, and so many times that bound where steps are
/// closer. Of six values of irregular errors one set in fourteen looks smooth; its limit is farther off than that in
/// one of four hundred (than twice the last D in one of four). Rounding is raised to (h₁ + h₂)/(h₁ − h₂) `digits` by
/// the extrapolation, which counts on top. Otherwise the limit is the finest value, and errors of first order, |d(h) −
/// L| ≤ K h, are off by K h there: K is taken as twice the greatest |d(h) − d(finest)|/h. Where the changes of the last
/// values fall twice like an order p below 1, e_n = D r^{−p}/(1 − r^{−p}) of the last of them, and the uncertainty is
/// at least twice that. Values that do not settle (the greater of the last two differences of neighbours, over h,
/// exceeds 2.5 times the greatest of those before: over two halvings that is an order below 1/3) are taken to wander
/// on: the limit is known to twice the greater of those two differences.
Limit limit_of(const std::vector<double>& h, const std::vector<double>& values, double floor, double digits = 0);

/// One answer against what an engine gave. Errors are shares of the answer's scale.
struct Graded {
  Answer answer;
  std::vector<double> steps_in_scale = {}, error = {};
  Limit limit{};
  double digits = 0;                                        ///< the greatest that printing took of one of its numbers
  double floor = 0;                                         ///< f: to which the answer is known, rounding and digits
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
  std::string what = {};  ///< in a sentence
  bool repeated = false;  ///< every run was repeated here to rounding
  double misfit = 0;      ///< greatest difference, shares of scale, at the runs or in the limit
  bool rule = false;      ///< a rule for tangential springs that engines have and say, and nothing else
  bool as_asked = false;  ///< repeated by steps of what was asked, which converge to the answer
};

struct CaseGrade {
  const Case* of = nullptr;
  Verdict verdict = Verdict::not_run;
  std::vector<Graded> answers = {};
  std::optional<EnergyBalance> energy = {};  ///< of cases without gravity
  std::vector<Cause> causes = {};            ///< the best first
  std::string note = {};                     ///< the engine's own, or why it was not graded
  bool by_repetition = false;                ///< it converges because every run was repeated, not by its limits

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

/// The grade of runs of which it is known otherwise that they converge to the answer: where their limits seemed to be
/// elsewhere, or none, they were known to no better than by how much they are off it.
void note_that_it_converges(CaseGrade& grade);

/// What an end state says of an asked number, `time` [s] after the touch.
double measured(const Case& of, const Run& run, const Asked& asked);

/// By how much the printed digits leave that open.
double measured_to(const Case& of, const Run& run, const Asked& asked);

struct EngineGrade {
  Results results;
  std::vector<CaseGrade> cases;

  std::size_t count(Verdict verdict) const;
  std::size_t right() const { return count(Verdict::exact) + count(Verdict::converges); }
  /// What could be graded: steps that are too coarse tell nothing.
  std::size_t run() const { return cases.size() - count(Verdict::not_run) - count(Verdict::too_coarse); }
};

}  // namespace ricochet::verify::conformance
