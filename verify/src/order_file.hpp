#pragma once

#include <string>
#include <vector>

namespace ricochet::verify {

/// One case of a file of convergence data: the meshes of one scheme, in the order of the file.
struct OrderCase {
  std::string scheme, name;
  std::vector<double> h, value;  ///< errors or values
};

/// What `verify order` reads.
struct OrderFile {
  bool errors = false;  ///< the column is `error`, else `value`
  std::vector<OrderCase> cases;
};

/// Reads columns h or n (h = 1/n), error or value, and, where there are, scheme and case. Throws console::BadInput
/// naming file, line and column.
OrderFile read_order_file(const std::string& path);

}  // namespace ricochet::verify
