#include "convergence_figures.hpp"

#include "convergence_tables.hpp"

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

/// A triangle of slope −order between two numbers of steps, a factor below the lowest error that the curves of that
/// order have there.
std::string triangle(const Panel& panel, double order, int object) {
  const auto& steps = panel.cases.front()->steps;
  // A second order's triangle stands farther right, where it does not cover the first.
  const std::size_t first = (object % 2 == 1 ? 2 : 5) * steps.size() / 9;
  const std::size_t last = std::min(first + 2, steps.size() - 1);
  double least = std::numeric_limits<double>::infinity();
  const double n1 = static_cast<double>(steps[first]), n2 = static_cast<double>(steps[last]);
  for (const Convergence* c : panel.cases)
    for (std::size_t i = first; i <= last && *c->statement.order == order; ++i)
      if (c->errors[i] > 0) least = std::min(least, c->errors[i] * std::pow(static_cast<double>(steps[i]) / n1, order));
  if (!std::isfinite(least)) return {};
  const double top = 0.3 * least, bottom = top * std::pow(n1 / n2, order);
  return fmt::format(
      "set object {0} polygon from {1},{2} to {1},{3} to {4},{3} to {1},{2} fs transparent solid 0.15 fc rgb "
      "'#767676'\n"
      "set label {0} '{5:.3g}' at {1},{6} right offset -0.6,0 font ',10' tc rgb '#767676'\n",
      object, n1, shortest(top), shortest(bottom), n2, order, shortest(std::sqrt(top * bottom)));
}

std::string triangles(const Panel& panel) {
  std::vector<double> orders;
  for (const Convergence* c : panel.cases) orders.push_back(*c->statement.order);
  std::sort(orders.begin(), orders.end());
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
  std::string script = "unset object\nunset label\n";
  int object = 1;
  for (const double order : orders) script += triangle(panel, order, object++);
  return script;
}

std::string style(std::size_t function) {
  return fmt::format("with linespoints lt {} lw 1.6 pt {} ps 0.6", function % 7 + 1, function + 4);
}

/// "t_col" with all of "col" below the line.
std::string enhanced(const std::string& function) {
  const auto underscore = function.find('_');
  if (underscore == std::string::npos) return function;
  return fmt::format("{}_{{{}}}", function.substr(0, underscore), function.substr(underscore + 1));
}

/// The CSV that the panels draw: a block a curve.
std::string csv_of(const std::vector<Panel>& panels) {
  std::string csv = "function,alpha,N,error\n";
  bool first = true;
  for (const Panel& panel : panels)
    for (const Convergence* c : panel.cases) {
      if (!first) csv += "\n\n";
      first = false;
      for (std::size_t i = 0; i < c->steps.size(); ++i)
        if (c->errors[i] > 0)
          csv += fmt::format("\"{}\",{},{},{}\n", c->statement.function, shortest(c->statement.alpha), c->steps[i],
                             shortest(c->errors[i]));
    }
  return csv;
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

std::string script_of(const std::vector<Panel>& panels, const std::vector<std::string>& functions,
                      const std::string& file) {
  const auto [low, high] = error_range(panels);
  const auto& steps = panels.front().cases.front()->steps;
  std::string script = fmt::format(
      "set multiplot layout {},3 margins 0.07,0.99,0.09,0.95 spacing 0.055,0.13\nunset key\nset logscale xy\n"
      "set xrange [{}:{}]\nset yrange [1e{}:1e{}]\nset format y '10^{{%T}}'\nset xlabel 'N' offset 0,0.6\n"
      "set ylabel 'error' offset 1.2,0\nset ytics 100\nunset mytics\n",
      (panels.size() + 3) / 3, shortest(0.6 * static_cast<double>(steps.front())),
      shortest(1.6 * static_cast<double>(steps.back())), low, high);
  std::size_t block = 0;
  for (const Panel& panel : panels) {
    script += fmt::format("set title 'α = {}' offset 0,-0.5\n{}", panel.alpha, triangles(panel));
    std::string separator = "plot ";
    for (const Convergence* c : panel.cases) {
      const auto function = std::find(functions.begin(), functions.end(), c->statement.function) - functions.begin();
      script += fmt::format("{}'{}' {}index {} using 3:4 {} notitle", separator, file, block == 0 ? "skip 1 " : "",
                            block, style(static_cast<std::size_t>(function)));
      separator = ", \\\n  ";
      ++block;
    }
    script += "\n";
  }
  script +=
      "unset object\nunset label\nunset title\nunset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\n"
      "set key at graph 0.05,0.9 left top spacing 1.3 samplen 2\nset xrange [1:2]\nset yrange [1:2]\n";
  std::string separator = "plot ";
  for (std::size_t i = 0; i < functions.size(); ++i) {
    script += fmt::format("{}NaN {} title '{}'", separator, style(i), enhanced(functions[i]));
    separator = ", ";
  }
  return script + "\nunset multiplot\n";
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
    const std::string name = fmt::format("{}-{}", prefix, file_word(scheme)), file = name + ".csv";
    figures.push_back(
        {.name = name,
         .caption = fmt::format("{}: error against the number of steps N; triangles: the stated order.", scheme),
         .script = script_of(panels, functions_of(panels), file),
         .data = {{file, csv_of(panels)}},
         .width = 1050,
         .height = 330 * static_cast<int>((panels.size() + 3) / 3),
         .finding = finding(panels)});
  }
  return figures;
}

}  // namespace ricochet::verify
