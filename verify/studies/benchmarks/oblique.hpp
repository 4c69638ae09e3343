#pragma once

#include "row.hpp"

namespace ricochet::verify::benchmarks {

/// Tests 4–8 of Chung & Ooi (2011): spheres that meet a rigid plane obliquely (4: at one speed, 5: at one normal
/// velocity, x = v_t/(μ v_n)), that spin and meet it (6, x = (7/2) μ (1+e) v_n/v_st), each other (7), or a larger and
/// far heavier one (8); and MFiX's DEM05. Hertz and Mindlin but for the last, which has linear springs. Exact: the
/// binary collision with the same contact point.
std::vector<Row> oblique_rows();

/// What the papers' curves say where that law is meant by them; see the remark.
void add_curve_gates(std::vector<Gate>& gates);

/// Why curves are compared in part only.
std::string curve_remark();

}  // namespace ricochet::verify::benchmarks
