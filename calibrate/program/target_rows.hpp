#pragma once

#include "job.hpp"

#include <calibrate/direct_calibrator.hpp>
#include <console/csv.hpp>

#include <array>
#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::calibration {

/// One block of rows, answered.
struct Answers {
  std::string text;                     ///< CSV rows
  std::vector<std::string> complaints;  ///< "file:line: en = 2: must be in (0, 1]", the first few
  std::size_t rows = 0, failed = 0;
  std::exception_ptr broken = nullptr;
};

/// Takes the lines up to and including the header from the first block that has one; `line` is its number. Throws
/// console::BadInput where the file has none.
std::string take_header(console::LineBlocks& source, console::LineBlocks::Block& block, const std::string& file,
                        std::size_t& line);

/// The rows of one file of targets: reads them by its header, calibrates, writes them. Shared by threads.
class TargetRows {
 public:
  static constexpr std::size_t most_complaints = 1000;

  /// Throws console::BadInput naming file, line, the column and the accepted ones. `calibrator` must outlive the rows.
  TargetRows(std::string file, std::size_t line, std::string_view header, const TargetDefaults& defaults,
             const DirectCalibrator& calibrator);

  std::string header() const;
  Answers answer(const console::LineBlocks::Block& block) const;

 private:
  enum Field : std::size_t { tcol, en, velocity, mass_eff, law, end, stiffness, count };
  static constexpr std::array<std::string_view, count> names{"tcol", "en",  "velocity", "mass_eff",
                                                             "law",  "end", "stiffness"};
  static constexpr std::array<std::string_view, count> units{" [s]", "", " [m/s]", " [kg]", "", "", " [kg/s^2]"};
  /// What a row says, as far as it could be read.
  struct Row {
    std::array<std::string_view, count> text{};
    std::array<std::optional<double>, count> number{};
    Request request;
  };

  Field field_of(std::size_t line, std::string_view column) const;
  void split(std::string_view line, Row& row) const;
  void read(Row& row) const;
  double number(Row& row, Field field, std::optional<double> otherwise) const;
  void write(std::string& out, const Row& row, std::string_view status, const AnyLaw* law) const;

  std::string file_;
  TargetDefaults defaults_;
  std::vector<Field> columns_;                         // of the file
  std::vector<std::string> parameters_;                // columns of the answer
  std::array<std::array<std::size_t, 3>, 5> place_{};  // of a law's parameters among them
  const DirectCalibrator& calibrator_;
};

}  // namespace ricochet::calibration
