#pragma once

#include "grain.hpp"

#include <verify/study.hpp>

namespace ricochet::verify::oblique {

/// The measured points of both readings beside the three laws, and the gates that they make.
void compare_with_measured(StudyResult& result);

/// The reference curves of Chung & Ooi's test 4 beside the same materials here.
void compare_with_chung_ooi(StudyResult& result);

/// Thornton's normalised curve: gross sliding, where it says the same for every contact.
void compare_with_thornton(StudyResult& result);

/// e_t, spin and angle of rebound over the angle of impact: curves, measured points, reference.
console::Figure rebound_figure();
/// Slip after over slip before, both in units of μ(1+e_n)v_n/2: the three laws, the three-parameter model, Thornton's.
console::Figure normalised_figure();

}  // namespace ricochet::verify::oblique
