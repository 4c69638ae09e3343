#include "temporary_folder.hpp"

#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>

using namespace ricochet::console;

TEST_CASE("gnuplot draws SVG and PNG beside the data, in any locale") {
  const char* locale = GENERATE("C", "C.UTF-8", "de_DE.UTF-8");
  ::setenv("LC_ALL", locale, 1);
  const TemporaryFolder folder;
  OutputFolder plots(folder / "plots");
  draw({"line",
        "A straight line",
        "plot 'line.csv' skip 1 using 1:2 with lines title 'ζ [µm]'",
        {{"line.csv", "x,y\n0,0\n1,1\n"}}},
       plots);
  plots.commit();
  ::unsetenv("LC_ALL");
  CHECK(read_file(folder / "plots/line.csv") == "x,y\n0,0\n1,1\n");
  CHECK(read_file(folder / "plots/line.svg").find("</svg>") != std::string::npos);
  CHECK(read_file(folder / "plots/line.png").substr(1, 3) == "PNG");
}

TEST_CASE("gnuplot's complaint is reported and nothing is drawn") {
  const TemporaryFolder folder;
  {
    OutputFolder plots(folder.path());
    CHECK_THROWS_WITH(draw({"bad", "", "plot nonsense(", {}}, plots), Catch::Contains("gnuplot, figure bad"));
    CHECK_THROWS_AS(draw({"empty", "", "plot 'none.csv'", {}}, plots), Failed);
    plots.commit();
  }
  CHECK(folder.count() == 0);
}

TEST_CASE("a machine without gnuplot gets the package's name") {
  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  CHECK_THROWS_WITH(svg_of({"x", "", "plot x", {}}), Catch::Contains("gnuplot-nox"));
  ::setenv("PATH", path.c_str(), 1);
}
