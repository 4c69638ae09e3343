#pragma once

#include "job.hpp"

#include <calibrate/direct_calibrator.hpp>
#include <console/csv.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
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
  std::uint64_t taken = 0;  ///< which defaults some row took, see TargetRows::idle
  std::exception_ptr broken = nullptr;
};

/// The rows of one file of targets: reads them by its header, calibrates, writes them. Shared by threads.
class TargetRows {
 public:
  static constexpr std::size_t most_complaints = 1000;

  /// Throws console::BadInput naming file, line, the column and the accepted ones. `calibrator` must outlive the rows.
  TargetRows(std::string file, const console::CsvHead& head, const TargetDefaults& defaults,
             const DirectCalibrator& calibrator, std::string_view first_rows = {});

  std::string header() const;
  Answers answer(const console::LineBlocks::Block& block) const;
  /// Headings that are no columns of targets, whose fields are not read.
  const std::vector<std::string>& ignored() const { return columns_.ignored(); }
  /// Those of the given flags that no row took, where `taken` is what all answers took together: "--en".
  static std::vector<std::string> idle(std::uint64_t taken, const std::vector<std::string>& given);

 private:
  /// The columns: those of `fields`, two words, and the stiffness in the other unit that it may have.
  static constexpr std::size_t law = fields.size(), end = law + 1, hertzian = end + 1, count = hertzian + 1;
  /// Defaults beside them, as bits of Answers::taken.
  static constexpr std::size_t match = count, wall = match + 1, form = wall + 1;
  static constexpr std::uint64_t bit(std::size_t what) { return std::uint64_t{1} << what; }
  static const std::array<console::CsvColumn, count> accepted;

  /// What a row says, as far as it could be read.
  struct Row {
    std::array<std::string_view, count> text{};
    std::optional<Asked> asked;  // its numbers, the defaults where it has none
    std::optional<double> mass_eff;
    Request request;
    bool solved = false;
    std::optional<LinearTangential> tangential;
    std::uint64_t taken = 0;  // of the defaults
  };

  void require_topics(std::size_t line) const;
  std::optional<Infeasible> add_tangential(Row& row, const Scale& scale) const;
  double number(std::size_t column, std::string_view text, Asked& own) const;
  void stiffness(std::size_t column, std::string_view text, Asked& own) const;
  void numbers(const Row& row, Asked& own) const;
  Asked asked_by(Row& row) const;
  void leave_unheld(Row& row, LawKind kind) const;
  std::variant<AnyLaw, Infeasible> calibrated(Row& row) const;
  void write(std::string& out, const Row& row, std::string_view status, const AnyLaw* law) const;

  std::string file_;
  TargetDefaults defaults_;
  console::CsvColumns columns_;
  bool nothing_by_default_ = false;                                                 // but the velocity
  bool tangential_ = false;                                                         // a tangential law may be asked for
  std::vector<std::size_t> numeric_;                                                // the file's columns of numbers
  std::vector<std::string> parameters_;                                             // columns of the answer
  std::array<std::array<std::size_t, Laws::most_parameters>, Laws::size> place_{};  // of a law's parameters among them
  const DirectCalibrator& calibrator_;
};

}  // namespace ricochet::calibration
