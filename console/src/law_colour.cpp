#include <console/law_colour.hpp>
#include <console/plot.hpp>

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

}  // namespace ricochet::console
