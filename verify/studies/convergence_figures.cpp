#include "convergence_figures.hpp"

#include "convergence_tables.hpp"

#include <console/gnuplot.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ricochet::verify {

namespace {

using console::shortest;

/// What a panel shows: the cases of one α that have an order.
struct Panel {
  double alpha;
  std::vector<const Convergence*> cases;
};

std::vector<Panel> panels_of(const std::vector<Convergence>& cases) {
  std::vector<Panel> panels;
  for (const Convergence& c : cases) {
    if (!c.statement.order) continue;
    const auto found =
        std::find_if(panels.begin(), panels.end(), [&](auto& p) { return p.alpha == c.statement.alpha; });
    (found == panels.end() ? panels.emplace_back(Panel{c.statement.alpha, {}}) : *found).cases.push_back(&c);
  }
  return panels;
}

std::vector<std::string> functions_of(const std::vector<Panel>& panels) {
  std::vector<std::string> functions;
  for (const Panel& panel : panels)
    for (const Convergence* c : panel.cases)
      if (std::find(functions.begin(), functions.end(), c->statement.function) == functions.end())
        functions.push_back(c->statement.function);
  return functions;
}

/// Adds a triangle of slope −order between two numbers of steps, a factor below every curve there, so that none crosses
/// it or the number at its left; `place` counts the triangles of a panel.
void add_triangle(console::Panel& drawn, const Panel& panel, double order, std::size_t place) {
  const auto& steps = panel.cases.front()->steps;
  // A second order's triangle stands farther right, where it does not cover the first.
  const std::size_t first = (place % 2 == 0 ? 2 : 5) * steps.size() / 9;
  const std::size_t last = std::min(first + 2, steps.size() - 1);
  double least = std::numeric_limits<double>::infinity();
  const double n1 = static_cast<double>(steps[first]), n2 = static_cast<double>(steps[last]);
  for (const Convergence* c : panel.cases)
    for (std::size_t i = first; i <= last; ++i)
      if (c->errors[i] > 0) least = std::min(least, c->errors[i] * std::pow(static_cast<double>(steps[i]) / n1, order));
  if (!std::isfinite(least)) return;
  const double top = 0.3 * least, bottom = top * std::pow(n1 / n2, order);
  const std::string gray = console::palette::gray;
  drawn.polygons.push_back(
      {{{n1, top}, {n1, bottom}, {n2, bottom}}, "fs transparent solid 0.15 fc rgb '" + gray + "'"});
  drawn.labels.push_back({fmt::format("{:.3g}", order), n1, std::sqrt(top * bottom),
                          fmt::format("right offset -0.6,0 font ',10' tc rgb '{}'", gray)});
}

void add_triangles(console::Panel& drawn, const Panel& panel) {
  std::vector<double> orders;
  for (const Convergence* c : panel.cases) orders.push_back(*c->statement.order);
  std::sort(orders.begin(), orders.end());
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
  for (std::size_t k = 0; k < orders.size(); ++k) add_triangle(drawn, panel, orders[k], k);
}

std::string style(std::size_t function) {
  return fmt::format("linespoints lt {} lw 1.6 pt {} ps 0.6", function % 7 + 1, function + 4);
}

/// "t_col" with all of "col" below the line.
std::string enhanced(const std::string& function) {
  const auto underscore = function.find('_');
  if (underscore == std::string::npos) return function;
  return fmt::format("{}_{{{}}}", function.substr(0, underscore), function.substr(underscore + 1));
}

/// What the panels draw: a series a curve, which function and alpha name.
console::SeriesFile file_of(const std::string& figure, const std::vector<Panel>& panels) {
  console::SeriesFile file(figure + ".csv", "function,alpha,N,error");
  for (const Panel& panel : panels)
    for (const Convergence* c : panel.cases) {
      file.begin();
      for (std::size_t i = 0; i < c->steps.size(); ++i)
        if (c->errors[i] > 0)
          file.add(fmt::format("\"{}\",{},{},{}", c->statement.function, shortest(c->statement.alpha), c->steps[i],
                               shortest(c->errors[i])));
    }
  return file;
}

/// Decades that hold every error and the triangles below them.
std::pair<double, double> error_range(const std::vector<Panel>& panels) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Panel& panel : panels)
    for (const Convergence* c : panel.cases)
      for (const double e : c->errors) {
        if (e > 0) low = std::min(low, e);
        if (std::isfinite(e)) high = std::max(high, e);
      }
  return {std::floor(std::log10(low)) - 1, std::ceil(std::log10(high))};
}

/// "(59) derivative" -> "59-derivative".
std::string file_word(const std::string& scheme) {
  std::string word;
  for (const char c : scheme) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!word.empty() && word.back() != '-')
      word += '-';
  }
  return word;
}

/// The axes of all panels.
console::Panel empty_panel(const std::vector<Panel>& panels) {
  const auto [low, high] = error_range(panels);
  const auto& steps = panels.front().cases.front()->steps;
  return {.x = {.label = "N",
                .log = true,
                .range = std::pair(0.6 * static_cast<double>(steps.front()), 1.6 * static_cast<double>(steps.back())),
                .label_offset = "0,0.6"},
          .y = {.label = "error",
                .log = true,
                .range = std::pair(std::pow(10, low), std::pow(10, high)),
                .format = "10^{%T}",
                .tics = 100,
                .minor_tics = false,
                .label_offset = "1.2,0"}};
}

console::Plot drawn(const std::vector<Panel>& panels, const std::vector<std::string>& functions,
                    const console::SeriesFile& file) {
  console::Plot plot{.layout = console::Layout{.rows = static_cast<int>((panels.size() + 3) / 3),
                                               .columns = 3,
                                               .left = 0.095,
                                               .right = 0.99,
                                               .bottom = 0.09,
                                               .top = 0.95,
                                               .between_columns = 0.085,
                                               .between_rows = 0.13},
                     .key_panel = "at graph 0.05,0.9 left top spacing 1.3 samplen 2"};
  std::size_t series = 0;
  for (const Panel& panel : panels) {
    plot.panels.push_back(empty_panel(panels));
    console::Panel& one = plot.panels.back();
    one.title = fmt::format("α = {}", panel.alpha);
    add_triangles(one, panel);
    for (const Convergence* c : panel.cases) {
      const auto function = std::find(functions.begin(), functions.end(), c->statement.function) - functions.begin();
      one.curves.push_back({.file = file.name(),
                            .rows = file.rows(series++),
                            .what = "3:4",
                            .style = style(static_cast<std::size_t>(function))});
    }
  }
  for (std::size_t i = 0; i < functions.size(); ++i)
    plot.key.push_back({.style = style(i), .title = enhanced(functions[i])});
  return plot;
}

/// What was observed against what is stated, in words.
std::string finding(const std::vector<Panel>& panels) {
  double worst = 0;
  std::size_t cases = 0;
  for (const Panel& panel : panels)
    for (const Convergence* c : panel.cases) {
      ++cases;
      const double off = std::fabs(c->observed() - *c->statement.order);
      if (!(off <= worst)) worst = off;
    }
  return fmt::format("In {} cases the observed order is within {:.2f} of the stated one.", cases, worst);
}

}  // namespace

std::vector<console::Figure> convergence_figures(const std::vector<Convergence>& all, const std::string& prefix) {
  std::vector<console::Figure> figures;
  for (const auto& cases : by_scheme(all)) {
    const std::vector<Panel> panels = panels_of(cases);
    if (panels.empty()) continue;
    const std::string& scheme = cases[0].statement.scheme;
    const std::string name = fmt::format("{}-{}", prefix, file_word(scheme));
    const console::SeriesFile file = file_of(name, panels);
    figures.push_back(
        {.name = name,
         .caption = fmt::format("{}: error against the number of steps N; triangles: the stated order.", scheme),
         .plot = drawn(panels, functions_of(panels), file),
         .data = {file.data()},
         .width = 1050,
         .height = 330 * static_cast<int>((panels.size() + 3) / 3),
         .finding = finding(panels)});
  }
  return figures;
}

}  // namespace ricochet::verify
