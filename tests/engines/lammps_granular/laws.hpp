#pragma once

#include <string>
#include <vector>

namespace engines {

/// The laws beside the fractional one, in the form by t_col and e_n, for impacts of 0.5 m/s.
struct Solid {
  std::string name;
  std::string open;  ///< what follows t_col and e_n
};

inline const std::vector<Solid> solids{
    {"fractional/kelvin_voigt", "NULL"}, {"fractional/hertz", "NULL 0.5"}, {"fractional/zener", "NULL NULL"}};

}  // namespace engines
