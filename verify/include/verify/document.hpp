#pragma once

#include <verify/study.hpp>

#include <string>
#include <vector>

namespace ricochet::verify {

/// The JSON document of a study: {"schema", "claim", "verdict", <extra>, "gates", "remarks", "rows"}.
console::Json study_json(const Study& study, const StudyResult& result);

/// What `verify <study> --format …` prints. CSV is for the data: the study's long table, its only table, or else
/// every cell of its tables in a row of its own.
std::string study_text(const Study& study, const StudyResult& result, console::Format format);

/// One row a cell: study, table (its caption), row (from 1), column, unit, value.
console::Table cell_table();
void add_cells(console::Table& cells, const std::string& study, const StudyResult& result);

/// A <testsuite> with one <testcase> a gate, and the document of several.
std::string junit_suite(const std::string& study, const std::vector<Gate>& gates);
std::string junit_document(const std::string& suites);

}  // namespace ricochet::verify
