#include "case_json.hpp"

#include <verify/conformance.hpp>

#include <console/output.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify {

namespace {

using namespace conformance;
using console::Table;

Table list_of(const std::vector<Case>& cases) {
  Table table({{"case"}, {"family"}, {"title"}, {"source"}}, "Cases of contact models");
  for (const Case& c : cases) table.row({c.name, c.family, c.title, c.source});
  return table;
}

/// The greatest error that an answer may have, as a share of its scale: what engines are off by at 100 steps is to be
/// told from it.
constexpr double well_known = 5e-3;

double worst_answer(const std::vector<Case>& cases) {
  double worst = 0;
  for (const Case& c : cases)
    for (const Answer& a : answers(c)) worst = std::max(worst, a.error / a.scale);
  return worst;
}

void write_cases(const std::vector<Case>& cases, const std::string& folder) {
  console::OutputFolder files(folder);
  for (const Case& c : cases) files.add(c.name + ".json", console::document(to_json(c)));
  files.commit();
}

class Conformance : public Study {
 public:
  std::string name() const override { return "conformance"; }
  std::string claim() const override {
    return "Engines give what the contact models give that they are asked for, in cases with exact answers";
  }
  void add_options(CLI::App& app) override {
    app.add_flag("--list", list_, "the cases");
    app.add_option("--cases", folder_, "write each case as DIR/<case>.json")->type_name("DIR");
  }
  StudyResult run(const RunOptions&) override {
    const std::vector<Case> cases = all_cases();
    StudyResult result;
    result.tables = {list_of(cases)};
    result.gates = {at_most("error of an answer, share of its scale", worst_answer(cases), well_known)};
    if (!folder_.empty()) write_cases(cases, folder_);
    result.verdict = fmt::format("{} cases.", cases.size());
    return result;
  }

 private:
  bool list_ = false;
  std::string folder_;
};

}  // namespace

std::unique_ptr<Study> conformance_check() { return std::make_unique<Conformance>(); }

}  // namespace ricochet::verify
