#include <console/table.hpp>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace ricochet::console {

namespace {

/// LaTeX's own signs by their commands; the few Greek letters and signs that our tables use, for pdflatex.
std::string escaped_for_latex(const std::string& text) {
  struct Sign {
    const char *utf8, *command;
  };
  static constexpr Sign signs[] = {{"\\", "\\textbackslash{}"},
                                   {"{", "\\{"},
                                   {"}", "\\}"},
                                   {"&", "\\&"},
                                   {"%", "\\%"},
                                   {"$", "\\$"},
                                   {"#", "\\#"},
                                   {"_", "\\_"},
                                   {"~", "\\textasciitilde{}"},
                                   {"^", "\\textasciicircum{}"},
                                   {"<", "$<$"},
                                   {">", "$>$"},
                                   {"|", "$|$"},
                                   {"α", "$\\alpha$"},
                                   {"β", "$\\beta$"},
                                   {"δ", "$\\delta$"},
                                   {"Δ", "$\\Delta$"},
                                   {"ζ", "$\\zeta$"},
                                   {"µ", "$\\mu$"},
                                   {"²", "$^2$"},
                                   {"³", "$^3$"},
                                   {"−", "$-$"},
                                   {"±", "$\\pm$"},
                                   {"≤", "$\\le$"},
                                   {"≥", "$\\ge$"},
                                   {"∞", "$\\infty$"},
                                   {"\n", " "}};
  std::string escaped;
  for (std::size_t at = 0; at < text.size();) {
    const Sign* found = nullptr;
    for (const Sign& sign : signs)
      if (text.compare(at, std::string::traits_type::length(sign.utf8), sign.utf8) == 0) found = &sign;
    escaped += found ? found->command : std::string(1, text[at]);
    at += found ? std::string::traits_type::length(found->utf8) : 1;
  }
  return escaped;
}

std::string line(const std::vector<std::string>& cells) { return fmt::format("{} \\\\\n", fmt::join(cells, " & ")); }

}  // namespace

std::string Table::latex() const {
  std::string kinds;
  std::vector<std::string> head, units;
  bool any_unit = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    kinds += right_aligned(i) ? 'r' : 'l';
    head.push_back(escaped_for_latex(column.name));
    units.push_back(column.unit.empty() ? "" : fmt::format("[{}]", escaped_for_latex(column.unit)));
    any_unit |= !column.unit.empty();
  }
  std::string out = fmt::format(R"(\begin{{table}}
\centering
{}\begin{{tabular}}{{{}}}
\toprule
{}{}\midrule
)",
                                caption_.empty() ? "" : fmt::format("\\caption{{{}}}\n", escaped_for_latex(caption_)),
                                kinds, line(head), any_unit ? line(units) : "");
  for (const auto& row : rows_) {
    // A row that begins with "[" would be taken for an argument of \\.
    out += row.empty() || !shown(row[0], columns_[0].notation).starts_with('[') ? "" : "{}";
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < row.size(); ++i)
      cells.push_back(escaped_for_latex(shown(row[i], columns_[i].notation)));
    out += line(cells);
  }
  out += "\\bottomrule\n\\end{tabular}\n";
  for (const std::string& note : notes_)
    out += fmt::format("\\par\\smallskip\\footnotesize {}\n", escaped_for_latex(note));
  return out + "\\end{table}\n";
}

}  // namespace ricochet::console
