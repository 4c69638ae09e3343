#pragma once

#include <ricochet/collision/fractional_contact.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// The rows of data/fractional_contact_reference.csv; what it has no column for is 0.
inline std::vector<ricochet::FractionalContact> reference_contacts() {
  std::ifstream table(RICOCHET_SOURCE_DIR "/data/fractional_contact_reference.csv");
  std::vector<ricochet::FractionalContact> rows;
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'a') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    ricochet::FractionalContact r{};
    std::istringstream(line) >> r.alpha >> r.z_star >> r.tau >> r.en >> r.overlap_end >> r.z_max_overlap >>
        r.t_max_overlap >> r.max_overlap;
    rows.push_back(r);
  }
  return rows;
}
