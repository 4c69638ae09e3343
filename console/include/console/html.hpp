#pragma once

#include <console/plot.hpp>
#include <console/table.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

/// `text` for use between tags and inside quoted attributes: & < > " ' become entities, control characters spaces.
std::string escaped(std::string_view text);

/// `text` for use between tags, its mathematics set as such: e_n and t_col with an index, x^2, c^{1−α} and m^(1/2) with
/// an exponent, 8.8e-02 as 8.8·10⁻²; alpha as α, so beta0, mu, nu, en and tcol. Names such as max_overlap and --alpha
/// stay.
std::string html_text(std::string_view text);

/// A word that is its own anchor and file name: lower-case letters, digits and "-".
std::string slug(std::string_view text);

/// The word "passed" or "failed", which reads without its colour.
std::string html_status(bool passed);

struct HtmlLink {
  std::string address;  ///< relative to the page
  std::string text;
};

struct TableView {
  std::string id;                                  ///< unique in the page
  std::vector<HtmlLink> links = {};                ///< shown under the table: its CSV
  std::size_t shown = 16;                          ///< rows in sight; the others open on demand
  std::size_t most = 400;                          ///< rows in the page at all; beyond them the links have to do
  std::vector<std::vector<std::string>> raw = {};  ///< HTML that stands for the first cells of each row
};

/// A captioned table with column and row headers and units, inside a region that scrolls by itself and can be
/// focused, so that the page never scrolls sideways. Notes follow.
std::string html_table(const Table& table, const TableView& view);

/// A picture that carries its SVG in itself, on a phone that of one panel below another, with the figure's finding as
/// its alternative text, a caption and links.
std::string html_figure(const Figure& figure, const Pictures& pictures, const std::vector<HtmlLink>& links);

/// The way into a page, beside it where there is room, from elements of class "beside"; its id is "contents".
std::string html_contents(const std::vector<HtmlLink>& links);

/// A button that copies the text of the element `id`; `label` says what that is.
std::string html_copy(std::string_view id, std::string_view label);

/// Preformatted text with that button.
std::string html_code(std::string_view id, std::string_view label, std::string_view text);

/// What a page has besides the style and the script of all pages.
struct PageParts {
  std::string_view style = {}, script = {};
};

/// A whole document that loads nothing: styles (light, dark, print) and the few lines of script for copying are in it.
/// `title` is text, `body` HTML.
std::string html_page(std::string_view title, std::string_view body, const PageParts& own = {});

}  // namespace ricochet::console
