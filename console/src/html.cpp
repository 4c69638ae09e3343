#include "html_style.hpp"

#include <console/html.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::console {

namespace {

constexpr std::size_t wide_cell = 36;  ///< characters from which on a column may wrap
constexpr const char* wide_class = " class=\"wide\"";

/// The SVG as an address of its own. Only what would end the attribute or the address is encoded, and space, which ends
/// one of several addresses: it stays readable.
std::string as_address(const std::string& svg) {
  std::string address = "data:image/svg+xml;charset=utf-8,";
  for (const char c : svg) switch (c) {
      case '%': address += "%25"; break;
      case '#': address += "%23"; break;
      case '"': address += "%22"; break;
      case '<': address += "%3C"; break;
      case '>': address += "%3E"; break;
      case '&': address += "%26"; break;
      case '\n': address += "%0A"; break;
      case ' ':
      case '\t': address += "%20"; break;
      default: address += c;
    }
  return address;
}

std::string linked(const std::vector<HtmlLink>& links) {
  std::vector<std::string> all;
  all.reserve(links.size());
  for (const HtmlLink& link : links)
    all.push_back(fmt::format(R"(<a href="{}">{}</a>)", escaped(link.address), escaped(link.text)));
  return fmt::format("{}", fmt::join(all, " · "));
}

std::string under(std::string_view html) { return fmt::format("<p class=\"under\">{}</p>\n", html); }

bool is_wide(const Table& table, std::size_t column) {
  return std::any_of(table.rows().begin(), table.rows().end(), [&](const auto& row) {
    return display_width(shown(row[column], table.columns()[column].notation)) > wide_cell;
  });
}

/// The class of a column's cells, as an attribute.
std::string cell_class(const Table& table, std::size_t column) {
  if (table.right_aligned(column)) return " class=\"n\"";
  return is_wide(table, column) ? wide_class : "";
}

/// Cells of prose make a table too wide for a phone, where its cells stand below each other and need their names.
bool stacks(const std::vector<std::string>& classes) {
  return std::any_of(classes.begin(), classes.end(), [](const auto& each) { return each == wide_class; });
}

/// The column's name before a cell, in sight where cells stand below each other.
std::string own_name(const Column& column) {
  const std::string unit = column.unit.empty() ? "" : fmt::format(" [{}]", html_text(column.unit));
  return fmt::format(R"(<span class="own">{}{}: </span>)", html_text(column.name), unit);
}

std::string head(const Table& table, const std::vector<std::string>& classes) {
  std::string html = "<thead><tr>";
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const Column& column = table.columns()[i];
    const std::string unit =
        column.unit.empty() ? "" : fmt::format(R"(<span class="unit">{}</span>)", html_text(column.unit));
    html += fmt::format(R"(<th scope="col"{}>{}{}</th>)", classes[i], html_text(column.name), unit);
  }
  return html + "</tr></thead>\n";
}

std::string one_row(const Table& table, std::size_t row, const std::vector<std::string>& classes,
                    const TableView& view) {
  std::string html = "<tr>";
  const bool named = stacks(classes);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const bool raw = row < view.raw.size() && i < view.raw[row].size();
    const std::string plain = shown(table.rows()[row][i], table.columns()[i].notation);
    // A number can be copied as it stands.
    const std::string cell = raw ? view.raw[row][i] : table.right_aligned(i) ? escaped(plain) : html_text(plain);
    html += i == 0 && !cell.empty() ? fmt::format(R"(<th scope="row"{}>{}</th>)", classes[i], cell)
                                    : fmt::format("<td{}>{}{}</td>", classes[i],
                                                  named && !cell.empty() ? own_name(table.columns()[i]) : "", cell);
  }
  return html + "</tr>\n";
}

std::string rows_of(const Table& table, const TableView& view, std::size_t first, std::size_t last,
                    const std::vector<std::string>& classes) {
  const bool part = first > 0;
  std::string html = fmt::format(R"(<div class="scroll" tabindex="0" role="group" aria-labelledby="{id}">
<table{stacks}><caption id="{id}">{caption}{rows}</caption>
{head}<tbody>
)",
                                 fmt::arg("id", view.id + (part ? "-more" : "")),
                                 fmt::arg("stacks", stacks(classes) ? " class=\"stacks\"" : ""),
                                 fmt::arg("caption", html_text(table.caption())),
                                 fmt::arg("rows", part ? fmt::format(", rows {} to {}", first + 1, last) : ""),
                                 fmt::arg("head", head(table, classes)));
  for (std::size_t r = first; r < last; ++r) html += one_row(table, r, classes, view);
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      case '\'': html += "&#39;"; break;
      default: html += static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t' ? ' ' : c;
    }
  return html;
}

std::string slug(std::string_view text) {
  std::string word;
  for (const char c : text)
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      word += c;
    else if (c >= 'A' && c <= 'Z')
      word += static_cast<char>(c - 'A' + 'a');
    else if (!word.empty() && word.back() != '-')
      word += '-';
  while (!word.empty() && word.back() == '-') word.pop_back();
  return word;
}

std::string html_status(bool passed) {
  return passed ? R"(<span class="status pass">passed</span>)" : R"(<span class="status fail">failed</span>)";
}

std::string html_table(const Table& table, const TableView& view) {
  std::vector<std::string> classes;
  for (std::size_t i = 0; i < table.columns().size(); ++i) classes.push_back(cell_class(table, i));
  const std::size_t all = std::min(table.rows().size(), view.most);
  // A handful of rows more is no reason to hide them.
  const std::size_t first = all <= view.shown + view.shown / 4 ? all : view.shown;
  std::string html = rows_of(table, view, 0, first, classes);
  if (first < all)
    html += fmt::format("<details><summary>{} more rows</summary>\n{}</details>\n", all - first,
                        rows_of(table, view, first, all, classes));
  if (all < table.rows().size())
    html += under(fmt::format("{} further rows are in the CSV file.", table.rows().size() - all));
  for (const std::string& note : table.notes()) html += under(html_text(note));
  if (!view.links.empty()) html += under(linked(view.links));
  return html;
}

std::string html_figure(const Figure& figure, const Pictures& pictures, const std::vector<HtmlLink>& links) {
  const std::string finding = figure.finding.empty() ? figure.caption : figure.finding;
  const std::string source = links.empty() ? "" : fmt::format(R"(<br><span class="soft">{}</span>)", linked(links));
  return fmt::format(R"html(<figure><picture><source media="(max-width:40rem)" srcset="{narrow}">)html"
                     R"(<img src="{wide}" width="{width}" height="{height}" alt="{finding}"></picture>
<figcaption>{caption}{said}{source}</figcaption></figure>
)",
                     fmt::arg("narrow", as_address(pictures.narrow)), fmt::arg("wide", as_address(pictures.wide)),
                     fmt::arg("width", figure.width), fmt::arg("height", figure.height),
                     fmt::arg("finding", escaped(finding)), fmt::arg("caption", html_text(figure.caption)),
                     fmt::arg("said", figure.finding.empty() ? "" : fmt::format(" {}", html_text(figure.finding))),
                     fmt::arg("source", source));
}

std::string html_contents(const std::vector<HtmlLink>& links) {
  std::string list;
  for (const HtmlLink& link : links)
    list += fmt::format("<li><a href=\"{}\">{}</a></li>\n", escaped(link.address), html_text(link.text));
  return fmt::format("<nav class=\"contents\" id=\"contents\" aria-label=\"Contents\">\n<ul>\n{}</ul>\n</nav>\n", list);
}

std::string html_copy(std::string_view id, std::string_view label) {
  return fmt::format(R"(<button type="button" hidden data-copy="{}" aria-label="Copy {}">Copy</button>)", id,
                     escaped(label));
}

std::string html_code(std::string_view id, std::string_view label, std::string_view text) {
  return fmt::format(R"(<div class="code"><div class="bar"><span>{label}</span>{copy}</div>)"
                     R"(<pre tabindex="0" role="region" aria-label="{label}"><code id="{id}">{text}</code></pre></div>
)",
                     fmt::arg("label", escaped(label)), fmt::arg("copy", html_copy(id, label)), fmt::arg("id", id),
                     fmt::arg("text", escaped(text)));
}

std::string html_page(std::string_view title, std::string_view body, const PageParts& own) {
  return fmt::format(R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="Ricochet">
<link rel="icon" href="data:,">
<title>{}</title>
<style>{}{}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the content</a>
{}<script>{}{}</script>
</body>
</html>
)",
                     escaped(title), page_style, own.style, body, page_script, own.script);
}

}  // namespace ricochet::console
