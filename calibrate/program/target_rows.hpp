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

/// The rows of one file of targets: reads them by its header, calibrates, writes them. Shared by threads.
class TargetRows {
 public:
  static constexpr std::size_t most_complaints = 1000;

  /// Throws console::BadInput naming file, line, the column and the accepted ones. `calibrator` must outlive the rows.
  TargetRows(std::string file, const console::CsvHead& head, const TargetDefaults& defaults,
             const DirectCalibrator& calibrator);

  std::string header() const;
  Answers answer(const console::LineBlocks::Block& block) const;

 private:
  enum Field : std::size_t { tcol, en, velocity, mass_eff, law, end, stiffness, count };
  static constexpr std::array<console::CsvColumn, count> accepted{console::CsvColumn{"tcol", "s", true},
                                                                  {"en", "", true},
                                                                  {"velocity", "m/s"},
                                                                  {"mass_eff", "kg"},
                                                                  {"law"},
                                                                  {"end"},
                                                                  {"stiffness", "kg/s^2"}};
  /// What a row says, as far as it could be read.
  struct Row {
    std::array<std::string_view, count> text{};
    std::array<std::optional<double>, count> number{};
    Request request;
  };

  void read(Row& row) const;
  double number(Row& row, Field field, std::optional<double> otherwise) const;
  void write(std::string& out, const Row& row, std::string_view status, const AnyLaw* law) const;

  std::string file_;
  TargetDefaults defaults_;
  console::CsvColumns columns_;
  std::vector<std::string> parameters_;                                             // columns of the answer
  std::array<std::array<std::size_t, Laws::most_parameters>, Laws::size> place_{};  // of a law's parameters among them
  const DirectCalibrator& calibrator_;
};

}  // namespace ricochet::calibration
