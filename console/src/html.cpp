#include "html_style.hpp"

#include <console/html.hpp>

#include <algorithm>

namespace ricochet::console {

namespace {

constexpr std::size_t wide_cell = 36;  ///< characters from which on a column may wrap

/// The SVG as an address of its own. Only what would end the attribute or the address is encoded: it stays readable.
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
      case '\t': address += ' '; break;
      default: address += c;
    }
  return address;
}

std::string linked(const std::vector<HtmlLink>& links) {
  std::string html;
  for (const HtmlLink& link : links)
    html += (html.empty() ? "" : " · ") + ("<a href=\"" + escaped(link.address) + "\">" + escaped(link.text) + "</a>");
  return html;
}

bool is_wide(const Table& table, std::size_t column) {
  return std::any_of(table.rows().begin(), table.rows().end(), [&](const auto& row) {
    return display_width(shown(row[column], table.columns()[column].notation)) > wide_cell;
  });
}

/// The class of a column's cells, as an attribute.
std::string cell_class(const Table& table, std::size_t column) {
  if (table.right_aligned(column)) return " class=\"n\"";
  return is_wide(table, column) ? " class=\"wide\"" : "";
}

std::string head(const Table& table, const std::vector<std::string>& classes) {
  std::string html = "<thead><tr>";
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const Column& column = table.columns()[i];
    html += "<th scope=\"col\"" + classes[i] + ">" + escaped(column.name) +
            (column.unit.empty() ? "" : "<span class=\"unit\">" + escaped(column.unit) + "</span>") + "</th>";
  }
  return html + "</tr></thead>\n";
}

std::string one_row(const Table& table, std::size_t row, const std::vector<std::string>& classes,
                    const TableView& view) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::string tag = i == 0 ? "th scope=\"row\"" : "td";
    const bool raw = i == 0 && !view.raw_first.empty();
    html += "<" + tag + classes[i] + ">" +
            (raw ? view.raw_first[row] : escaped(shown(table.rows()[row][i], table.columns()[i].notation))) +
            (i == 0 ? "</th>" : "</td>");
  }
  return html + "</tr>\n";
}

std::string rows_of(const Table& table, const TableView& view, std::size_t first, std::size_t last,
                    const std::vector<std::string>& classes) {
  const bool part = first > 0;
  const std::string id = view.id + (part ? "-more" : "");
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-labelledby=\"" + id +
                     "\">\n<table><caption id=\"" + id + "\">" + escaped(table.caption()) +
                     (part ? ", rows " + std::to_string(first + 1) + " to " + std::to_string(last) : "") +
                     "</caption>\n" + head(table, classes) + "<tbody>\n";
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
  return passed ? "<span class=\"status pass\">passed</span>" : "<span class=\"status fail\">failed</span>";
}

std::string html_table(const Table& table, const TableView& view) {
  std::vector<std::string> classes;
  for (std::size_t i = 0; i < table.columns().size(); ++i) classes.push_back(cell_class(table, i));
  const std::size_t all = std::min(table.rows().size(), view.most);
  // A handful of rows more is no reason to hide them.
  const std::size_t first = all <= view.shown + view.shown / 4 ? all : view.shown;
  std::string html = rows_of(table, view, 0, first, classes);
  if (first < all)
    html += "<details><summary>" + std::to_string(all - first) + " more rows</summary>\n" +
            rows_of(table, view, first, all, classes) + "</details>\n";
  if (all < table.rows().size())
    html +=
        "<p class=\"under\">" + std::to_string(table.rows().size() - all) + " further rows are in the CSV file.</p>\n";
  for (const std::string& note : table.notes()) html += "<p class=\"under\">" + escaped(note) + "</p>\n";
  if (!view.links.empty()) html += "<p class=\"under\">" + linked(view.links) + "</p>\n";
  return html;
}

std::string html_figure(const Figure& figure, const std::string& svg, const std::vector<HtmlLink>& links) {
  const std::string finding = figure.finding.empty() ? figure.caption : figure.finding;
  return "<figure><div class=\"picture\" tabindex=\"0\" role=\"group\" aria-label=\"" +
         escaped("Picture " + figure.name) + "\"><img src=\"" + as_address(svg) + "\" width=\"" +
         std::to_string(figure.width) + "\" height=\"" + std::to_string(figure.height) + "\" alt=\"" +
         escaped(finding) + "\"></div>\n<figcaption>" + escaped(figure.caption) +
         (figure.finding.empty() ? "" : " " + escaped(figure.finding)) +
         (links.empty() ? "" : "<br><span class=\"soft\">" + linked(links) + "</span>") + "</figcaption></figure>\n";
}

std::string html_code(std::string_view id, std::string_view label, std::string_view text) {
  const std::string name(id), said = escaped(label);
  return "<div class=\"code\"><div class=\"bar\"><span>" + said +
         "</span><span><span class=\"soft\" role=\"status\"></span> <button type=\"button\" hidden data-copy=\"" +
         name + "\" aria-label=\"Copy " + said +
         "\">Copy</button></span></div><pre tabindex=\"0\" role=\"region\" aria-label=\"" + said + "\"><code id=\"" +
         name + "\">" + escaped(text) + "</code></pre></div>\n";
}

std::string html_page(std::string_view title, std::string_view body) {
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"generator\" content=\"Ricochet\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" +
         escaped(title) + "</title>\n<style>" + page_style +
         "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n" +
         std::string(body) + "<script>" + page_script + "</script>\n</body>\n</html>\n";
}

}  // namespace ricochet::console
