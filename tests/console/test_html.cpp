#include <console/html.hpp>

#include <catch2/catch.hpp>

using namespace ricochet::console;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("text in a page cannot become markup") {
  CHECK(escaped("<a href=\"x\" b='y'>&\x01") == "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp; ");
  CHECK(slug("Fig. 5, α(nc)") == "fig-5-nc");
}

TEST_CASE("mathematics is set as people write it, and names stay what they are") {
  CHECK(html_text("e_n = 8.8e-02 at alpha = 0.25") == "<i>e</i><sub>n</sub> = 8.8·10<sup>−2</sup> at α = 0.25");
  CHECK(html_text("t_col, k_t; max_overlap, en_sigma, x_y_z") ==
        "<i>t</i><sub>col</sub>, <i>k</i><sub>t</sub>; max_overlap, en_sigma, x_y_z");
  CHECK(html_text("c^α k^{1−α} D^α ζ") == "c<sup>α</sup> k<sup>1−α</sup> D<sup>α</sup> ζ");
  CHECK(html_text("c^alpha k^(1-alpha), x^alphabet") == "c<sup>α</sup> k<sup>1−α</sup>, x<sup>a</sup>lphabet");
  CHECK(html_text("kg/(s^2 m^(1/2)), s^(alpha-2), 10^-4 s, t^p") ==
        "kg/(s<sup>2</sup> m<sup>1/2</sup>), s<sup>α−2</sup>, 10<sup>−4</sup> s, t<sup>p</sup>");
  CHECK(html_text("K D^a z^1.5. x^2.") == "K D<sup>a</sup> z<sup>1.5</sup>. x<sup>2</sup>.");
  CHECK(html_text("--alpha 0.5, alpha_max, 1e30, 2.5e+05, 1e-04, -1e6, 1.1e2, 21e2") ==
        "--alpha 0.5, alpha_max, 10<sup>30</sup>, 2.5·10<sup>5</sup>, 10<sup>−4</sup>, -10<sup>6</sup>, "
        "1.1·10<sup>2</sup>, 21·10<sup>2</sup>");
  CHECK(html_text("tcol = 1 s, en, beta0, mu and nu; --en, en_sigma, tcol.csv, ten") ==
        "<i>t</i><sub>col</sub> = 1 s, <i>e</i><sub>n</sub>, <i>β</i><sub>0</sub>, μ and ν; --en, en_sigma, "
        "<i>t</i><sub>col</sub>.csv, ten");
  CHECK(html_text("a < b^2 & x^") == "a &lt; b<sup>2</sup> &amp; x^");
  CHECK(html_text("P(EC)2E, 3e, 0x1e5z, (^(") == "P(EC)2E, 3e, 0x1e5z, (^(");
}

TEST_CASE("a table in a page has a caption, headers with units, and hides what is long") {
  Table table({{"law"}, {"k", "kg/s²"}}, "Laws & ends");
  for (int i = 0; i < 50; ++i) table.row({"law " + std::to_string(i), 1.5 * i});
  table.note("a note");
  const std::string html = html_table(table, {.id = "t", .links = {{"t.csv", "t.csv"}}, .shown = 10, .most = 30});
  CHECK(html.find("<caption id=\"t\">Laws &amp; ends</caption>") != std::string::npos);
  CHECK(html.find("<th scope=\"col\" class=\"n\">k<span class=\"unit\">kg/s²</span></th>") != std::string::npos);
  CHECK(html.find("<th scope=\"row\">law 3</th><td class=\"n\">4.5</td>") != std::string::npos);
  CHECK(html.find("<summary>20 more rows</summary>") != std::string::npos);
  CHECK(html.find("20 further rows are in the CSV file.") != std::string::npos);
  CHECK(html.find("<a href=\"t.csv\">t.csv</a>") != std::string::npos);
  CHECK(count(html, "tabindex=\"0\"") == 2);
  CHECK(count(html, "scope=\"row\"") == 30);
}

TEST_CASE("cells of a table with prose have their column's name for a phone, where they stand below each other") {
  const auto page_of = [](const std::string& words) {
    Table table({{"study"}, {"tcol", "s"}, {"found"}, {"remark"}}, "Studies");
    table.row({std::string("one"), 1.5, words, std::string()});
    return html_table(table, {.id = "t"});
  };
  const std::string prose = page_of("thirty-seven characters are much here");
  CHECK(prose.find("<table class=\"stacks\">") != std::string::npos);
  CHECK(prose.find("<th scope=\"row\">one</th>"
                   "<td class=\"n\"><span class=\"own\"><i>t</i><sub>col</sub> [s]: </span>1.5</td>"
                   "<td class=\"wide\"><span class=\"own\">found: </span>thirty") != std::string::npos);
  CHECK(prose.find("<td></td></tr>") != std::string::npos);  // of an empty cell nothing is to be seen
  CHECK(page_of("six and thirty: these fit on a line.").find("own") == std::string::npos);
}

TEST_CASE("a figure in a page carries its picture and says its finding") {
  const Figure figure{.name = "line",
                      .caption = "A line.",
                      .plot = {.panels = {{.curves = {{.what = "x", .style = "lines"}}}}},
                      .finding = "It rises."};
  const Pictures pictures = pictures_of(figure);
  const std::string& svg = pictures.wide;
  CHECK(svg.find("<title>A line.</title>") != std::string::npos);
  CHECK(svg.find("<desc>It rises.</desc>") != std::string::npos);
  CHECK(svg.find("prefers-color-scheme:dark") != std::string::npos);
  const std::string html = html_figure(figure, pictures, {});
  CHECK(html.find("alt=\"It rises.\"") != std::string::npos);
  CHECK(html.find("src=\"data:image/svg+xml") != std::string::npos);
  CHECK(html.find("<svg") == std::string::npos);
  // A list of addresses ends each at a space.
  const auto narrow = html.find("<source media=\"(max-width:40rem)\" srcset=\"data:image/svg+xml"),
             end = html.find("\">", narrow);
  REQUIRE(narrow != std::string::npos);
  CHECK(html.find(' ', html.find("srcset=", narrow)) > end);
}

TEST_CASE("a cell can be HTML of its own, its neighbours stay text, and code has a button that copies it") {
  Table table({{"law"}, {"engine"}, {"k"}}, "t");
  table.row({"a", "b", "<c>"});
  table.row({"d", "e", "f"});
  const std::string html = html_table(table, {.id = "t", .raw = {{"<b>A</b>", html_copy("x", "it & all")}}});
  CHECK(html.find("<tr><th scope=\"row\"><b>A</b></th><td><button type=\"button\" hidden data-copy=\"x\" "
                  "aria-label=\"Copy it &amp; all\">Copy</button></td><td>&lt;c&gt;</td></tr>") != std::string::npos);
  CHECK(html.find("<th scope=\"row\">d</th><td>e</td>") != std::string::npos);
  const std::string code = html_code("x", "it", "a < b");
  CHECK(code.find("data-copy=\"x\"") != std::string::npos);
  CHECK(code.find("<code id=\"x\">a &lt; b</code>") != std::string::npos);
  CHECK(html_contents({{"#a", "alpha"}}).find("<li><a href=\"#a\">α</a></li>") != std::string::npos);
}
