#pragma once

#include <calibrate/calibration.hpp>

namespace ricochet::calibration {

/// What given parameters do under a constant load [N], ended by force (ricochet/collision/loaded.hpp). Infeasible where
/// the load keeps the bodies together: from which speed on they part is said. Throws as `collide_under_load`.
Outcome answer_under_load(const AnyLaw& law, const Impact& impact, double load);

/// `calibrate` under a constant load > 0, ended by force. In the units of the target (m, tcol, v₀) the load is N
/// tcol/(m v₀), a second group, so stiffness and loss no longer part: `direct` is a bracketed root in the loss of a
/// bracketed root in the stiffness, `nlopt` searches both at once. Each asks collide_under_load alone. Relative error
/// in tcol and en: 1e-8.
Outcome calibrate_under_load(const Request& request, double load, const Settings& settings = {});

}  // namespace ricochet::calibration
