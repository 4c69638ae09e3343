#pragma once

#include "convergence.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ricochet::verify {

/// Every field of "0.1,0.5" as a number. Throws CLI::ValidationError that names `flag` and a field that is none.
std::vector<double> numbers(const std::string& flag, const std::vector<std::string>& fields);

/// What a user wants of a convergence study; empty lists: everything.
class Selection {
 public:
  /// --scheme, --function (both may be given several times), --alpha, --steps, --summary.
  void add_options(CLI::App& app);

  /// Throws console::BadInput for a word that is none of these, an α outside [0.01, 0.97], fewer than three numbers of
  /// steps, ones that do not grow, or a number outside [4, 65536].
  void check(const std::vector<std::string>& schemes, const std::vector<std::string>& functions) const;

  bool scheme(const std::string& name) const;
  bool function(const std::string& name) const;
  std::vector<double> alphas() const;  ///< else studied_orders
  std::vector<std::size_t> steps(std::size_t finest) const;
  bool summary_only() const { return summary_; }
  /// Nothing is chosen: the whole study with what stands beside its convergence.
  bool everything() const { return schemes_.empty() && functions_.empty() && alphas_.empty() && steps_.empty(); }

 private:
  std::vector<std::string> schemes_, functions_;
  std::vector<double> alphas_;
  std::vector<std::size_t> steps_;
  bool summary_ = false;
};

/// Gates, rows, long data, summary, tables and figures of a convergence study; `prefix` begins the figures' names. The
/// verdict lacks its full stop. Throws console::BadInput where nothing was chosen.
StudyResult convergence_result(const std::vector<Convergence>& all, const Selection& wanted, const std::string& prefix);

}  // namespace ricochet::verify
