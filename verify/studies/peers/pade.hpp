#pragma once

#include <console/json.hpp>
#include <console/table.hpp>
#include <verify/gate.hpp>

#include <vector>

namespace ricochet::verify::peers {

/// Kuwabara and Kono's e(v) by the Padé form of Müller and Pöschel, beside the integrated collision.
console::Table pade_table();
/// "en_asked" is the form's, "en_obtained" the collision's.
std::vector<console::Json> pade_rows();
std::vector<Gate> pade_gates();

}  // namespace ricochet::verify::peers
