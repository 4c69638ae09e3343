#include <console/law_colour.hpp>
#include <console/plot.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::console {

const char* law_colour(std::string_view words) noexcept {
  struct Named {
    std::string_view law;
    const char* colour;
  };
  constexpr Named named[] = {{"linear", palette::blue},
                             {"linear1", palette::blue},
                             {"linear2", palette::blue},
                             {"kuwabara-kono", palette::green},
                             {"nonlinear", palette::green},
                             {"tsuji", palette::orange},
                             {"hysteretic", palette::purple},
                             {"fractional", palette::vermilion},
                             {"fractional-kelvin-voigt", palette::sky},
                             {"fractional-hertz", palette::black},
                             {"fractional-zener", palette::gray}};
  const std::string_view law = words.substr(0, words.find_first_of(" ,"));
  for (const Named& n : named)
    if (n.law == law) return n.colour;
  return palette::gray;
}

std::string law_line(const std::vector<std::string>& titles, std::size_t at) {
  const std::string_view colour = law_colour(titles[at]);
  const auto before = std::count_if(titles.begin(), titles.begin() + static_cast<std::ptrdiff_t>(at),
                                    [&](const std::string& title) { return law_colour(title) == colour; });
  return fmt::format("lc rgb '{}' dt {}", colour, before + 1);
}

}  // namespace ricochet::console
