#pragma once

#include <console/output.hpp>

#include <string>
#include <vector>

namespace ricochet::console {

/// "a/b" -> "a/", "b" -> "./".
std::string folder_of(const std::string& path);

/// Lets all files take their places, or none, while signals wait. Throws CannotWrite where one cannot, BadInput where
/// two have the same place.
void put_in_place(const std::vector<Waiting*>& files);

}  // namespace ricochet::console
