#pragma once

#include <ricochet/collision/fractional_contact.hpp>

#include <console/csv.hpp>

#include <array>
#include <vector>

/// The rows of data/fractional_contact_reference.csv; what it has no column for is 0.
inline std::vector<ricochet::FractionalContact> reference_contacts() {
  using ricochet::FractionalContact;
  using ricochet::console::CsvColumn;
  constexpr std::array columns{
      CsvColumn{"alpha"},       CsvColumn{"z_star"},        CsvColumn{"tau"},           CsvColumn{"en"},
      CsvColumn{"overlap_end"}, CsvColumn{"z_max_overlap"}, CsvColumn{"t_max_overlap"}, CsvColumn{"max_overlap"}};
  constexpr std::array members{&FractionalContact::alpha,         &FractionalContact::z_star,
                               &FractionalContact::tau,           &FractionalContact::en,
                               &FractionalContact::overlap_end,   &FractionalContact::z_max_overlap,
                               &FractionalContact::t_max_overlap, &FractionalContact::max_overlap};
  ricochet::console::CsvReader table(RICOCHET_SOURCE_DIR "/data/fractional_contact_reference.csv", columns);
  std::vector<FractionalContact> rows;
  while (table.next()) {
    FractionalContact r{};
    for (std::size_t i = 0; i < members.size(); ++i) r.*members[i] = table.number(i);
    rows.push_back(r);
  }
  return rows;
}
