#include "falling.hpp"
#include "normal.hpp"
#include "oblique.hpp"
#include "row.hpp"

#include <verify/registry.hpp>

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify {

namespace {

using benchmarks::Row;

class Benchmarks : public Study {
 public:
  std::string name() const override { return "benchmarks"; }
  std::string title() const override { return "Published benchmarks of contact models"; }
  std::string claim() const override {
    return "Clusters meet the published benchmarks of contact models: Chung & Ooi (2011), MFiX DEM01-DEM05";
  }

  StudyResult run(const RunOptions&) override {
    std::vector<Row> rows = benchmarks::normal_rows();
    for (const std::vector<Row>& more : {benchmarks::falling_rows(), benchmarks::oblique_rows()})
      rows.insert(rows.end(), more.begin(), more.end());
    StudyResult result;
    benchmarks::add_gates(result.gates, rows);
    benchmarks::add_loading_gate(result.gates);
    benchmarks::add_curve_gates(result.gates);
    result.remarks = {{"Chung & Ooi, tests 4-6", benchmarks::curve_remark()}};
    result.tables = {benchmarks::table(rows)};
    result.rows = console::Json::array();
    for (const Row& row : rows) result.rows.push_back(benchmarks::to_json(row));
    const auto worst = [](const Row& a, const Row& b) { return a.errors.back() < b.errors.back(); };
    const Row& least_good = *std::max_element(rows.begin(), rows.end(), worst);
    result.verdict = fmt::format("{} numbers of {} tests; the worst, {} of {}, is off by {} of itself.", rows.size(),
                                 tests(rows), least_good.asked.quantity, least_good.asked.test,
                                 console::significant(least_good.errors.back(), 2));
    return result;
  }

 private:
  static std::size_t tests(const std::vector<Row>& rows) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) count += k == 0 || rows[k].asked.test != rows[k - 1].asked.test;
    return count;
  }
};

}  // namespace

std::unique_ptr<Study> benchmarks_study() { return std::make_unique<Benchmarks>(); }

}  // namespace ricochet::verify
