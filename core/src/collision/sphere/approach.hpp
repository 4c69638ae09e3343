#pragma once

#include <cstddef>
#include <vector>

namespace ricochet::collision {

/// ζ'' = −D^α ζ^{3/2}, ζ(0) = 0, ζ'(0) = 1, up to its turning point: with z = t^p, p = 5/2 − α,
///   ζ = t Σ c_j z^j,  ζ^{3/2} = t^{3/2} Σ b_j z^j,
/// as D^α turns t^{3/2+pj} into Γ(5/2+pj)/Γ(5/2+pj−α) t^{p(j+1)−1}, and two integrations that into t^{1+p(j+1)}. The
/// nearest singularity is the overlap's next zero, far behind the turning point: there 40 terms leave rounding alone.
class SphereApproach {
 public:
  explicit SphereApproach(double alpha);

  double turn() const noexcept { return turn_; }  ///< where ζ' = 0
  double overlap(double t) const;
  double rate(double t) const;
  /// d(ζ^{3/2})/dt over √t.
  double reduced_power_rate(double t) const;
  /// D^α ζ^{3/2} and D^α ζ at the turning point.
  double turning_force() const;
  double turning_derivative() const;

 private:
  double alpha_, p_, turn_ = 0;
  std::vector<double> overlap_, rate_, power_rate_, force_, derivative_;  // coefficients of z^j
};

}  // namespace ricochet::collision
