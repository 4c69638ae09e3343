#pragma once

namespace ricochet::fractional {

/// 1/Γ(x), exactly 0 at the poles of Γ; relative error below 10 ulp for x ≤ 30, growing with Γ's condition past it.
double reciprocal_gamma(double x);

/// 1/Γ(b − a), to full relative accuracy also where b − a nears a pole of Γ and the plain difference is rounded.
double reciprocal_gamma_of_difference(double b, double a);

}  // namespace ricochet::fractional
