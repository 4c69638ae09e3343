#pragma once

#include "row.hpp"

namespace ricochet::verify::benchmarks {

/// Tests 1–3 of Y. C. Chung and J. Y. Ooi, Granular Matter 13, 643 (2011): two like spheres (glass, limestone) and a
/// sphere against a rigid plane (aluminium and magnesium alloys) meet elastically by Hertz's law; alumina and cast iron
/// rebound with a given restitution. Materials as Yade's scripts of the tests have them
/// (examples/chung-ooi-2011-benchmarks), answers of test 1 as printed.
std::vector<Row> normal_rows();

/// Force against overlap of test 1, glass, as read off the paper's curve, over the greatest force; against ours.
void add_loading_gate(std::vector<Gate>& gates);

}  // namespace ricochet::verify::benchmarks
