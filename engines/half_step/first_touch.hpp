#pragma once

#include <ricochet/contact/fractional.hpp>
#include <ricochet/contact/fractional_hertz.hpp>
#include <ricochet/contact/fractional_kelvin_voigt.hpp>
#include <ricochet/contact/fractional_zener.hpp>

namespace ricochet::half_step {

/// Weight w(θ) of the first kick after a touch that lies θ of a step back, 0 < θ ≤ 1: a force (t − t_b)^p, summed as
/// dt Σ_{k≥0} F((k + θ) dt) with w(θ) dt^p in place of the first F, has no start error of order 1 + p.
/// w(θ) = −ζ(−p, 1+θ), the Hurwitz zeta function, by Euler–Maclaurin; |error| < 1e-7 for 0 ≤ p ≤ 1, 2e-6 for p ≤ 3/2.
/// Source: I. Navot, J. Math. and Phys. 40, 271 (1961).
double start_weight(double p, double theta) noexcept;

/// The first kick [N] of a contact that touched `theta` of a step `dt` [s] back and has approached at `rate` [m/s]
/// since: the law's own force at a constant rate with start_weight in the place of each power of the time.
///   fractional-kelvin-voigt  k t + c t^{1−α}/Γ(2−α)
///   fractional-hertz         (k t^{3/2} + c Γ(5/2) t^{3/2−α}/Γ(5/2−α)) v^{3/2}
///   fractional-zener         k t + k₁ t E_{α,2}(−(t/τ)^α)
/// The last is no power of the time: its kick comes from Euler and Maclaurin's formula itself, from the third kick
/// after it on and without their third derivative, |error| < 4e-5 of the arm's force after a step.
double first_kick(const Fractional& law, double rate, double theta, double dt) noexcept;
double first_kick(const FractionalKelvinVoigt& law, double rate, double theta, double dt) noexcept;
double first_kick(const FractionalHertz& law, double rate, double theta, double dt) noexcept;
double first_kick(const FractionalZener& law, double rate, double theta, double dt) noexcept;

/// The work [J] of the law's force over the time `since` [s] after the touch, at a constant rate [m/s].
double first_work(const Fractional& law, double rate, double since) noexcept;
double first_work(const FractionalKelvinVoigt& law, double rate, double since) noexcept;
double first_work(const FractionalHertz& law, double rate, double since) noexcept;
double first_work(const FractionalZener& law, double rate, double since) noexcept;

}  // namespace ricochet::half_step
