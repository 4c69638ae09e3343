#include "../../console/src/stacked.hpp"
#include "../../console/src/svg_corners.hpp"
#include "../../console/src/svg_theme.hpp"
#include "temporary_folder.hpp"

#include <console/exit.hpp>
#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
#include <console/output.hpp>
#include <console/panels.hpp>
#include <console/plot.hpp>
#include <ricochet/contact/laws.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace ricochet::console;

namespace {

/// Of a PNG's chunk, bit by bit (PNG, annex D).
std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
  }
  return ~crc;
}

/// A figure of one panel with this curve.
Figure figure_of(const std::string& name, const Curve& curve, const std::vector<DataFile>& data = {}) {
  return {.name = name, .caption = "", .plot = {.panels = {{.curves = {curve}, .key = "top left"}}}, .data = data};
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return number;
}

}  // namespace

TEST_CASE("gnuplot draws SVG and, as large in print, PDF and PNG beside the data, in any locale") {
  const char* locale = GENERATE("C", "C.UTF-8", "de_DE.UTF-8");
  ::setenv("LC_ALL", locale, 1);
  const TemporaryFolder folder;
  OutputFolder plots(folder / "plots");
  draw(figure_of("line", {.file = "line.csv", .what = "1:2", .style = "lines", .title = "ζ [µm]"},
                 {{"line.csv", "x,y\n0,0\n1,1\n"}}),
       plots);
  plots.commit();
  ::unsetenv("LC_ALL");
  CHECK(read_file(folder / "plots/line.csv") == "x,y\n0,0\n1,1\n");
  CHECK(read_file(folder / "plots/line.svg").find("</svg>") != std::string::npos);
  // 720 by 450 pixels of a screen, 96 to the inch: 7.5 by 4.6875 inches.
  const std::string pdf = read_file(folder / "plots/line.pdf"), png = read_file(folder / "plots/line.png");
  CHECK(pdf.substr(0, 5) == "%PDF-");
  if (pdf.find("/ObjStm") == std::string::npos) {  // from 1.18 on Cairo packs these into compressed objects
    CHECK(pdf.find("/MediaBox [ 0 0 540 337") != std::string::npos);  // .5 cut off by some versions of Cairo
    CHECK(pdf.find("/CreationDate (D:20000101000000") != std::string::npos);
  }
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(number_at(png, 16) == 2250);
  CHECK(number_at(png, 20) == 1406);
  CHECK(png.substr(37, 4) == "pHYs");
  CHECK(number_at(png, 41) == 11811);  // to the metre
  CHECK(number_at(png, 45) == 11811);
  CHECK(number_at(png, 50) == crc_of(png.substr(37, 13)));
}

TEST_CASE("a panel's script says all that is said about it") {
  const Panel panel{.title = "one",
                    .x = {.label = "t [s]", .log = true, .range = std::pair(0.5, 8.0), .format = "", .tics = 2},
                    .y = {.label = "it's", .minor_tics = false, .label_offset = "1,0", .names = {"a", "b"}},
                    .curves = {{.file = "a.csv", .what = "1:2", .style = "lines lt 1", .title = "a"},
                               {.file = "a.csv", .rows = Rows{3, 5}, .what = "1:3", .style = "points"},
                               {.what = "0", .style = "lines"}},
                    .key = "left top",
                    .zero_line = true,
                    .labels = {{"here", 1, -2.5, "right"}},
                    .polygons = {{{{1, 2}, {3, 4}, {5, 6}}, "fc lt 1"}},
                    .equal_scales = true};
  CHECK(script_of({.panels = {panel}}) == R"(set title 'one' offset 0,-0.5
unset logscale x
set xrange [0.5:8]
set logscale x
set format x ''
set xtics 2
set mxtics default
set xlabel 't [s]' offset 0,0
unset logscale y
set yrange [*:*]
set format y 
set ytics ('a' 0, 'b' 1)
unset mytics
set ylabel 'it''s' offset 1,0
unset label
set label 'here' at 1,-2.5 right
unset object
set object polygon from 1,2 to 3,4 to 5,6 to 1,2 fc lt 1
set key left top
unset offsets
set xzeroaxis lt 1 lc rgb 'black' lw 0.7
set size ratio -1
plot 'a.csv' skip 1 using 1:2 with lines lt 1 title 'a', \
  'a.csv' skip 1 every ::3::5 using 1:3 with points notitle, \
  0 with lines notitle
)");
}

TEST_CASE("gnuplot draws what panels describe, with the key in a panel of its own") {
  SeriesFile two("two.csv", "t,f,series");
  two.begin();
  for (const char* row : {"0,0,a", "1,1,a"}) two.add(row);
  two.begin();
  for (const char* row : {"0,1,b", "1,0,b", "2,0,b"}) two.add(row);
  two.begin();
  CHECK(two.data().bytes == "t,f,series\n0,0,a\n1,1,a\n0,1,b\n1,0,b\n2,0,b\n");
  CHECK((two.rows(1).first == 2 && two.rows(1).last == 4));
  CHECK_THROWS_AS(two.rows(2), std::logic_error);
  const Panel panel{
      .x = {.label = "t"},
      .y = {.label = "f"},
      .curves = {{.file = "two.csv", .rows = two.rows(0), .what = "1:2", .style = "lines lt 1", .title = "it's"},
                 {.file = "two.csv", .rows = two.rows(1), .what = "1:2", .style = "lines lt 2", .title = "other"}},
      .room = "graph 0,0.02,0.03,0"};
  const Plot plot{.panels = {panel},
                  .layout = Layout{.rows = 1, .columns = 2, .left = 0.1, .right = 0.9, .bottom = 0.1, .top = 0.9},
                  .key_panel = "left top"};
  const auto [svg, narrow] = pictures_of({"two", "Two lines", plot, {two.data()}});
  CHECK(svg.find("it's") != std::string::npos);
  CHECK(svg.find("other") != std::string::npos);
  CHECK(narrow.find("other") != std::string::npos);
  CHECK_THROWS_AS(pictures_of({"two", "", plot, {{"two.csv", "t,f\n"}}}), Failed);  // nothing to draw
}

TEST_CASE("gnuplot's complaint is reported and nothing is drawn") {
  const TemporaryFolder folder;
  {
    OutputFolder plots(folder.path());
    CHECK_THROWS_WITH(draw(figure_of("bad", {.what = "nonsense(", .style = "lines"}), plots),
                      Catch::Contains("gnuplot, figure bad"));
    CHECK_THROWS_AS(draw(figure_of("empty", {.file = "none.csv", .what = "1:2", .style = "lines"}), plots), Failed);
    plots.commit();
  }
  CHECK(folder.count() == 0);
}

TEST_CASE("what a user has set for gnuplot does not get into a figure") {
  const Figure figure =
      figure_of("line", {.file = "line.csv", .what = "1:2", .style = "lines"}, {{"line.csv", "x,y\n0,0\n1,1\n"}});
  const std::string plain = pictures_of(figure).wide;
  const TemporaryFolder home;
  std::ofstream(home / ".gnuplot") << "set title 'mine'\nset terminal nonsense\n";
  const std::string before = std::getenv("HOME") ? std::getenv("HOME") : "";
  ::setenv("HOME", home.path().c_str(), 1);
  ::setenv("GNUTERM", "nonsense", 1);
  ::setenv("FONTCONFIG_FILE", "/none", 1);
  const std::string theirs = pictures_of(figure).wide;
  for (const char* name : {"GNUTERM", "FONTCONFIG_FILE"}) ::unsetenv(name);
  ::setenv("HOME", before.c_str(), 1);
  CHECK(theirs == plain);
}

TEST_CASE("a machine without gnuplot gets the package's name") {
  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  CHECK_THROWS_WITH(pictures_of(figure_of("x", {.what = "x", .style = "lines"})), Catch::Contains("gnuplot-nox"));
  ::setenv("PATH", path.c_str(), 1);
}

TEST_CASE("a collision's panels have the prefix of the greatest value of all curves, whichever comes first") {
  const Motion strong{"strong", {{0, 0, 1, 0}, {2e-4, 3e-6, 0, 4e3}, {5e-4, 0, -1, 0}}};
  const Motion weak{"weak", {{0, 0, 1, 0}, {2e-6, 3e-9, 0, 4}}};
  const std::string script = script_of(collision_panels("c", "", {strong, weak}).plot);
  CHECK(script.find("time since the first touch [µs]") != std::string::npos);
  CHECK(script.find("overlap [µm]") != std::string::npos);
  CHECK(script.find("force [kN]") != std::string::npos);
  CHECK(script.find("($2*1e6):($3*1e6)") != std::string::npos);
  CHECK(script.find("($2*1e6):($5*1e-3)") != std::string::npos);
  CHECK(collision_panels("c", "", {weak, strong}).data.front().bytes.find("\"strong\",2e-04,3e-06,0,4000") !=
        std::string::npos);
}

TEST_CASE("a themed picture repaints each colour of the palette as gnuplot writes it, and says what it shows") {
  const std::string svg = themed("<svg><title>t</title><desc>d</desc></svg>", "A & B", "what is seen");
  for (const char* const rule :
       {R"x([stroke="rgb(0,114,178)"]{stroke:#45a3e6})x", R"x([fill="rgb(213,94,0)"]{fill:#ff8a3d})x",
        R"x([color="rgb(  0, 158, 115)"]{color:#2fc79a})x"})
    CHECK(svg.find(rule) != std::string::npos);
  CHECK(svg.find("<title>A &amp; B</title><desc>what is seen</desc>") != std::string::npos);
}

TEST_CASE("a law has one colour, whatever words stand behind its name, and no two share one") {
  CHECK(law_colour("fractional") == palette::vermilion);
  CHECK(law_colour("fractional, force") == palette::vermilion);
  CHECK(law_colour("fractional alpha=0.0258") == palette::vermilion);
  CHECK(law_colour("linear1") == law_colour("linear"));
  CHECK(law_colour("nonlinear") == law_colour("kuwabara-kono"));
  CHECK(law_colour("gravity") == palette::gray);
  std::set<std::string_view> colours;
  for (const std::string_view law : ricochet::Laws::names) colours.insert(law_colour(law));
  CHECK(colours.size() == ricochet::Laws::size);
}

TEST_CASE("the key of a collision names every curve of every law and end, and its time ends where they do") {
  const std::vector<Moment> moments{{0, 0, 1, 0}, {0.5, 1, 0, 1}, {1, 0, -1, 0}};
  std::vector<Motion> motions{{"linear, ended by overlap", moments}};
  for (const std::string_view law : ricochet::Laws::names)
    motions.push_back({std::string(law) + ", ended by force", moments});
  const Figure figure = collision_panels("laws", "", motions);
  const std::string svg = pictures_of(figure).wide;
  for (const Motion& motion : motions) {
    INFO(motion.title);
    CHECK(svg.find(">" + motion.title + "<") != std::string::npos);
  }
  CHECK(script_of(figure.plot).find("set xrange [0:1.03]") != std::string::npos);
}

TEST_CASE("a law that is drawn twice is dashed the second time") {
  const std::vector<Moment> moments{{0, 0, 1, 0}, {1, 1, 0, 1}};
  const Figure figure = collision_panels("laws", "", {{"linear1", moments}, {"tsuji", moments}, {"linear2", moments}});
  const std::string script = script_of(figure.plot);
  const auto drawn = [&](const char* colour, int dash) {
    return script.find(std::string("lc rgb '") + colour + "' dt " + std::to_string(dash) + " lw 2.2") !=
           std::string::npos;
  };
  CHECK(drawn(palette::blue, 1));
  CHECK(drawn(palette::blue, 2));
  CHECK(drawn(palette::orange, 1));
  CHECK_FALSE(drawn(palette::orange, 2));
}

TEST_CASE("on a phone panels stand one below another, with both axes each and the key under the first") {
  const auto panel = [](const char* y, bool labelled) {
    return Panel{.x = {.label = labelled ? "t" : "", .range = std::pair(0.0, 1.0), .format = labelled ? "%g" : ""},
                 .y = {.label = y},
                 .curves = {{.what = "x", .style = "lines", .title = "a"}, {.what = "1-x", .style = "lines"}}};
  };
  Figure figure{.name = "grid",
                .caption = "",
                .plot = {.panels = {panel("f", false), panel("", false), panel("g", true), panel("", true)},
                         .layout = Layout{.rows = 2, .columns = 2, .bottom = 0.1, .top = 0.9},
                         .key_panel = "left top"},
                .width = 1000,
                .height = 500};
  const auto labels = [&] {
    std::string all;
    for (const Panel& p : stacked(figure).plot.panels) all += p.x.label + p.y.label;
    return all;
  };
  CHECK(labels() == "tftftgtg");
  figure.plot.layout->down = true;
  CHECK(labels() == "tftgtftg");
  const Figure narrow = stacked(figure);
  CHECK(narrow.width < 480);
  CHECK(narrow.plot.panels.front().x.format == "%g");
  const double panel_height = 500 * 0.8 / 2;
  double above = 1;  // the lower end of the panel before, of the picture
  for (const Panel& p : narrow.plot.panels) {
    CHECK(narrow.height * (p.box->top - p.box->bottom) == Approx(panel_height));
    CHECK(p.box->top < above);
    above = p.box->bottom;
    // Half of 10000 at the right end of an axis, whose digits of 14 pixels are 0.636 of that wide (DejaVu Sans).
    CHECK(narrow.width * (1 - p.box->right) > 5 * 0.636 * 14 / 2);
  }
  CHECK(above > 0);
  // The key of all has one line, between the first panel and the second.
  const auto& panels = narrow.plot.panels;
  const double gap = panels[0].box->bottom - panels[1].box->top, other = panels[1].box->bottom - panels[2].box->top;
  CHECK(narrow.height * (gap - other) == Approx(25));
  CHECK(narrow.plot.key_panel.find("at screen 0.5,") == 0);
  CHECK_FALSE(pictures_of(figure).narrow.empty());
}

TEST_CASE("on a phone a key stands under its panel, wherever it stood") {
  const auto panel = [](const char* key) {
    return Panel{
        .curves = {{.what = "x", .style = "lines", .title = "a"}, {.what = "1", .style = "lines", .title = "b"}},
        .key = key};
  };
  const Figure figure{.name = "keys",
                      .caption = "",
                      .plot = {.panels = {panel("top left"), panel("outside right center"), panel("")},
                               .layout = Layout{.rows = 1, .columns = 3, .bottom = 0.1, .top = 0.9}}};
  const auto panels = stacked(figure).plot.panels;
  const auto gap = [&](std::size_t i) { return panels[i].box->bottom - (i < 2 ? panels[i + 1].box->top : 0); };
  for (const std::size_t keyed : {0, 1}) {
    CHECK(panels[keyed].key.find("at screen 0.5,") == 0);
    const double at = std::stod(panels[keyed].key.substr(std::string("at screen 0.5,").size()));
    CHECK(at < panels[keyed].box->bottom);
    CHECK(at > panels[keyed + 1].box->top);
  }
  CHECK(panels[2].key.empty());
  CHECK(gap(0) == Approx(gap(1)));
  CHECK(gap(0) > gap(2));
}

TEST_CASE("a key whose title would be wider than the picture has smaller letters, and is drawn") {
  const std::string words = "LAMMPS 29 Sep 2021 Update 2, 4 Feb 2025 with lammps-ricochet";
  const Panel panel{
      .curves = {{.what = "x", .style = "lines", .title = words}, {.what = "1", .style = "lines", .title = "short"}}};
  const Figure figure{.name = "long", .caption = "", .plot = with_key_below(panel, 2, 0.3), .width = 420};
  // 60 characters of 0.6 of the letters' size, and 14 more beside them, are 420 pixels.
  const auto key_at = [&](double width) { return with_keys_within(figure.plot, width, letters).panels[0].key; };
  CHECK(key_at(420) == figure.plot.panels[0].key + " font ',9.5'");
  CHECK(key_at(900) == figure.plot.panels[0].key);
  CHECK(with_keys_within({.panels = {panel}, .key_panel = "center"}, 420, letters).key_panel == "center font ',9.5'");
  CHECK(with_keys_within({.panels = {{}}, .key_panel = "center", .key = panel.curves}, 420, 2 * letters).key_panel ==
        "center font ',9.5'");
  // gnuplot names a curve's group by the title, in which the key's letters are.
  const Pictures drawn = pictures_of(figure);
  for (const std::string& picture : {drawn.wide, drawn.narrow}) {
    const auto curve = picture.find("gnuplot_plot_1"), named = picture.find(words, curve);
    REQUIRE(named != std::string::npos);
    CHECK(picture.find(words, named + 1) < picture.find("gnuplot_plot_2"));
  }
}

TEST_CASE("lines keep the corners that show, each within a tenth of a pixel, and groups that hold something") {
  // A parabola whose chords of n pixels sag by n^2/8000: those of 28 may stay, no steeper than 0.4.
  std::string path = "M0.00,0.00";
  for (int i = 1; i <= 400; ++i) path += " L" + std::to_string(i) + ".00," + std::to_string(i * i / 2000.0);
  const auto drawn = [](const std::string& d) { return "<svg><path stroke='black' d='" + d + "'/></svg>"; };
  const std::string thin = with_fewer_corners(drawn(path));
  std::vector<double> kept;
  for (auto at = thin.find_first_of("ML"); at != std::string::npos; at = thin.find_first_of("ML", at + 1))
    kept.push_back(std::stod(thin.substr(at + 1)));
  CHECK(kept.front() == 0);
  CHECK(kept.back() == 400);
  CHECK(kept.size() > 400 / 31);
  CHECK(kept.size() < 400 / 14);
  for (std::size_t i = 1; i < kept.size(); ++i) CHECK(kept[i] - kept[i - 1] < 31);

  CHECK(with_fewer_corners(drawn("M0,0 L5,0.05 L10,0 L10,10 \t\n")) == drawn("M0,0 L10,0 L10,10"));
  CHECK(with_fewer_corners(drawn("M0,0 L5,0.2 L10,0")) == drawn("M0,0 L5,0.2 L10,0"));
  // Closed, and several in one; there and back is a line too.
  CHECK(with_fewer_corners(drawn("M0,0 L5,0 L9,0 L9,9 Z M1,1 L3,1 L2,1")) == drawn("M0,0 L9,0 L9,9 Z M1,1 L3,1 L2,1"));
  const std::string arc = drawn("M-1,0 h2 M0,-1 v2"), numbers = drawn("M1,1 L2,x");
  CHECK(with_fewer_corners(arc) == arc);
  CHECK(with_fewer_corners(numbers) == numbers);
  CHECK(with_fewer_corners("<g fill=\"none\">\n</g>\n<g id=\"a\"><g id=\"b\"></g><text/></g>") ==
        "<g id=\"a\"><text/></g>");
}
