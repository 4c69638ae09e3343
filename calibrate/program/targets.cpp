#include "targets.hpp"

#include "target_rows.hpp"

#include <console/output.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::LineBlocks;

/// Answers the blocks on `threads` threads; which takes which does not show in the answers.
std::vector<Answers> answered(const TargetRows& rows, const std::vector<LineBlocks::Block>& blocks, unsigned threads) {
  std::vector<Answers> answers(blocks.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = 0; (i = next.fetch_add(1)) < blocks.size();) {
      try {
        answers[i] = rows.answer(blocks[i]);
      } catch (...) {
        answers[i].broken = std::current_exception();
      }
    }
  };
  std::vector<std::jthread> others;
  for (unsigned t = 1; t < std::min<std::size_t>(threads, blocks.size()); ++t) others.emplace_back(work);
  work();
  others.clear();
  for (const Answers& a : answers)
    if (a.broken) std::rethrow_exception(a.broken);
  return answers;
}

/// Says what is wrong with a row, until it has been said of many.
class Complaints {
 public:
  void add(const Answers& answers) {
    for (const auto& line : answers.complaints) {
      if (said_ == TargetRows::most_complaints) break;
      ++said_;
      console::complain("calibrate", line);
    }
    failed_ += answers.failed;
  }
  std::size_t finish() const {
    if (failed_ > said_)
      console::complain("calibrate", fmt::format("{} more rows failed; see the column status", failed_ - said_));
    return failed_;
  }

 private:
  std::size_t said_ = 0, failed_ = 0;
};

void refuse_what_is_not_for_files(const Options& o) {
  take_only(o, "--targets",
            flags_of({Topic::scale, Topic::loss, Topic::held, Topic::impact, Topic::tangential},
                     {"--targets", "--law", "--end", "--match", "--wall", "--tangential", "--method", "--threads",
                      "--format", "--output"}));
  if (o.method == "nlopt") throw BadInput("--method", o.method, "direct with --targets");
  if (o.end == "both") throw BadInput("--end", o.end, "overlap or force with --targets: one row out per row in");
  if (o.law == "all") throw BadInput("--law", o.law, "a single law with --targets: one row out per row in");
  if (was_given(o, "--format") && o.output.format != console::Format::csv)
    throw BadInput("--format: must be csv with --targets, whose rows are written as they are read");
}

}  // namespace

console::Exit run_targets(const Options& options) {
  refuse_what_is_not_for_files(options);
  const TargetDefaults defaults = target_defaults(options);
  const unsigned threads = options.threads ? *options.threads : std::max(1u, std::thread::hardware_concurrency());
  LineBlocks source(options.targets);
  std::vector<LineBlocks::Block> blocks(1);
  const auto head = console::take_csv_head(source, blocks[0]);
  if (!head)
    throw BadInput(
        fmt::format("{}:1: header missing: must be a row of columns, a scale (tcol) and a loss (en)", options.targets));
  const DirectCalibrator calibrator;
  const TargetRows rows(options.targets, *head, defaults, calibrator, blocks[0].text);
  if (!rows.ignored().empty())
    console::complain("calibrate", fmt::format("{}:{}: columns that are not read: {}", options.targets, head->line,
                                               fmt::join(rows.ignored(), ", ")));
  console::Output output(options.output.file);
  output.write(rows.header());
  console::Progress progress("calibrate", source.size());
  Complaints complaints;
  std::uint64_t taken = 0;
  bool any = false;
  // Rounds of a few blocks a thread: reading and writing take a small share of the time that the rows do.
  const std::size_t round = std::size_t{4} * threads;
  for (bool more = true; more;) {
    while (more && blocks.size() < round) {
      LineBlocks::Block block;
      if ((more = source.next(block))) blocks.push_back(std::move(block));
    }
    const auto answers = answered(rows, blocks, threads);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      output.write(answers[i].text);
      complaints.add(answers[i]);
      taken |= answers[i].taken;
      any = any || answers[i].rows > 0;
      progress.advance(blocks[i].text.size());
    }
    blocks.clear();
  }
  output.commit();
  if (const auto idle = TargetRows::idle(taken, options.given); any && !idle.empty())
    console::complain("calibrate",
                      fmt::format("{}: no row takes it: its columns or its law say otherwise", fmt::join(idle, ", ")));
  return complaints.finish() ? console::Exit::gate_failed : console::Exit::done;
}

}  // namespace ricochet::calibration
