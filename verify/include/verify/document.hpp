#pragma once

#include <verify/study.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace ricochet::verify {

/// Gates that passed and failed, and what was skipped, which is neither.
struct Counts {
  std::size_t passed = 0, failed = 0, skipped = 0;

  Counts& operator+=(const Counts& o) noexcept {
    passed += o.passed, failed += o.failed, skipped += o.skipped;
    return *this;
  }
};
Counts counts_of(const StudyResult& result);
console::Json to_json(const Counts& counts);

/// The JSON document of a study: {"schema", "claim", "verdict", <extra>, "counts", "skipped", "gates", "remarks",
/// "rows"}.
console::Json study_json(const Study& study, const StudyResult& result);

/// What `verify <study> --format …` prints. CSV is for the data: the study's long table, its only table, or else
/// every cell of its tables in a row of its own.
std::string study_text(const Study& study, const StudyResult& result, console::Format format);

/// One row a cell: study, table (its caption), row (from 1), column, unit, value.
console::Table cell_table();
void add_cells(console::Table& cells, const std::string& study, const StudyResult& result);

/// A <testsuite> with one <testcase> a gate and each that was skipped, and the document of several.
std::string junit_suite(const std::string& study, const StudyResult& result);
std::string junit_document(const std::string& suites);

}  // namespace ricochet::verify
