#include "matrix.hpp"

#include "badge.hpp"
#include "show.hpp"

#include <console/html.hpp>

#include <fmt/format.h>

namespace ricochet::verify::conformance {

namespace {

using console::escaped;

std::string head(const std::vector<EngineGrade>& engines) {
  std::string html = "<thead><tr><th scope=\"col\">case</th>";
  for (std::size_t i = 0; i < engines.size(); ++i)
    html += fmt::format("<th scope=\"col\" class=\"turned\"><a href=\"#engine-{}\">{} {}</a></th>",
                        file_stem(engines[i].results), i + 1, escaped(label(engines[i].results)));
  return html + "</tr></thead>\n";
}

std::string row(const std::vector<EngineGrade>& engines, std::size_t which) {
  const Case& of = *engines.front().cases[which].of;
  std::string html = fmt::format("<tr><th scope=\"row\" title=\"{}\">{}</th>", escaped(of.title), escaped(of.name));
  for (const EngineGrade& e : engines) {
    const CaseGrade& c = e.cases[which];
    html +=
        fmt::format("<td class=\"{}\" title=\"{}: {}{}{}\">{}</td>", colour_class(c.verdict), escaped(label(e.results)),
                    text(c.verdict), why(c).empty() ? "" : ": ", escaped(why(c)), console::html_text(sign_of(c)));
  }
  return html + "</tr>\n";
}

}  // namespace

// Tints of Okabe and Ito's colours, on which the page's ink reads in the light and in the dark.
const char* const matrix_style = R"css(
:root{--exact:#a9d7f4;--right:#d9eefb;--rule:#f2dcea;--else:#fbe0b4;--wander:#f4b69a;--coarse:#ece9e1}
@media (prefers-color-scheme:dark){:root{--exact:#0d4f78;--right:#17384d;--rule:#4b2c42;--else:#57400c;
--wander:#6d2a10;--coarse:#2d3138}}
.exact{background:var(--exact)}.right{background:var(--right)}.rule{background:var(--rule)}
.else{background:var(--else)}.wander{background:var(--wander)}.coarse{background:var(--coarse)}
.matrix{font-size:.8rem}
.matrix td{text-align:center;padding:.22rem .15rem;border-left:1px solid var(--line)}
.matrix tbody th{padding:.22rem .6rem;white-space:nowrap}
.matrix .family th{background:var(--mark);font-weight:600}
.turned{vertical-align:bottom;padding:.4rem .1rem;min-width:3.4rem;text-align:center}
.turned a{writing-mode:vertical-rl;transform:rotate(180deg);max-height:15rem;display:inline-block;line-height:1.2;
  font-weight:500}
.sign{color:var(--ink);display:inline-block;min-width:3.2rem;text-align:center;padding:0 .4rem;border-radius:.2rem;
  margin-right:.5rem}
@media print{.exact,.right,.rule,.else,.wander,.coarse{print-color-adjust:exact}}
)css";

const char* colour_class(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::exact: return "exact";
    case Verdict::converges: return "right";
    case Verdict::too_coarse: return "coarse";
    case Verdict::another_rule: return "rule";
    case Verdict::elsewhere: return "else";
    case Verdict::does_not_converge: return "wander";
    case Verdict::not_run: break;
  }
  return "not-run";
}

std::string matrix(const std::vector<EngineGrade>& engines) {
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-labelledby=\"cases\">\n<table "
      "class=\"matrix\"><caption "
      "id=\"cases\">Cases by engine</caption>\n{}",
      head(engines));
  std::string family;
  for (std::size_t i = 0; i < engines.front().cases.size(); ++i) {
    const std::string& now = engines.front().cases[i].of->family;
    if (now != family)
      html += fmt::format("{}<tbody><tr class=\"family\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                          family.empty() ? "" : "</tbody>\n", engines.size() + 1, escaped(now));
    family = now;
    html += row(engines, i);
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace ricochet::verify::conformance
