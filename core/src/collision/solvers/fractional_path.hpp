#pragma once

// What the schemes of fractional_solvers.hpp share. Inside, v₀ = A = m = 1: times in A^{−1/(2−α)}.

#include <cstddef>
#include <vector>

namespace ricochet::collision {

/// A memory kernel: spring + Σ strength exp(−rate t) + dashpot δ(t).
struct Exponentials {
  double spring = 0, dashpot = 0;
  std::vector<double> strength = {}, rate = {};
};

struct Mesh {
  double alpha;
  double first;  ///< length of the first step, (1 − offset)·step
  double step;
  double end;  ///< give up here, or stop exactly here if `exact`
  bool exact;

  bool by_overlap() const { return alpha < 0; }  ///< the overlap's zero ends the collision, not the force's
  double time(std::size_t n) const { return n == 0 ? 0 : first + static_cast<double>(n - 1) * step; }
  /// The step to time(n) leaves the mesh.
  bool past(std::size_t n) const { return time(n) > end * (1 + 1e-12); }
};

struct Path {
  std::vector<double> time{0}, overlap{0}, rate{1}, force{0};
  std::size_t kernel_evaluations = 0, multiplications = 0;

  void add(double t, double z, double v, double f) {
    time.push_back(t), overlap.push_back(z), rate.push_back(v), force.push_back(f);
  }
  /// What ends the collision has passed its zero. It starts from zero too, so the first point says nothing.
  bool ended(const Mesh& mesh) const { return time.size() > 2 && (mesh.by_overlap() ? overlap : force).back() <= 0; }
};

// Each follows the motion until what ends it has passed zero or the mesh ends.
Path rectangle_path(const Mesh& mesh);
Path rectangle_integral_path(const Mesh& mesh);
Path trapezoid_path(const Mesh& mesh);
Path arms_trapezoid_path(const Mesh& mesh, const Exponentials& kernel);
Path arms_exponential_path(const Mesh& mesh, const Exponentials& kernel);
Path arms_rosenbrock_path(const Mesh& mesh, const Exponentials& kernel);

}  // namespace ricochet::collision
