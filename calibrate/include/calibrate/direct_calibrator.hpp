#pragma once

#include <calibrate/calibration.hpp>

#include <memory>
#include <variant>

namespace ricochet::calibration {

/// The direct method for many targets. In the units of the target each law's parameters are functions of e_n alone;
/// here they are closed forms or piecewise polynomials in −ln e_n, made from the slow path when a law is first asked
/// for:
///
///   linear, overlap    k = (π² + ln²e_n) m/t²,  c = −2 ln e_n m/t                            closed form
///   linear, force      k by table, c as above
///   hysteretic         k₁ = (π/2)²(1 + e_n)² m/t²,  k₂ = k₁/e_n²                             closed form
///   kuwabara-kono      k = K m v₀^{−1/2} t^{−5/2},  c = C m v₀^{−1/2} t^{−3/2};  K, C by table
///   tsuji              k = K m v₀^{−1/2} t^{−5/2},  c = C m v₀^{−1/4} t^{−5/4};  K, C by table
///   fractional, force  α and z* = A t^{2−α} by FractionalContactTable, then c from (c/k)^α = z* m/(k t^{2−α})
///
/// Error: 1e-11 relative in every identifiable parameter (so 1e-11/α in the fractional law's c), more where the problem
/// itself has no more digits: 1e-14/|ln e_n| in c. Proved against `calibrate` in tests/calibrate. What the tables leave
/// out (e_n < 0.006, the fractional law ended by overlap and, but for 1, above e_n = 0.9999) goes the slow way, by
/// `unit_law`: as exact, and a thousand times slower (milliseconds). So do the laws of real solids, whose functions are
/// others for every α, 1 ms, of fractional-hertz 20; but what was found for an e_n is kept.
///
/// Immutable but for the tables, which are made once, and for what is kept; may be shared between threads, whose
/// answers are the same bits.
class DirectCalibrator {
 public:
  using Answer = std::variant<AnyLaw, Infeasible>;

  DirectCalibrator();
  ~DirectCalibrator();
  DirectCalibrator(const DirectCalibrator&) = delete;
  DirectCalibrator& operator=(const DirectCalibrator&) = delete;

  /// Throws std::invalid_argument as `calibrate` does.
  Answer operator()(const Request& request) const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace ricochet::calibration
