#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

/// The colour of a law in every picture, of the palette: one a law, however many are drawn. By its name, or the name
/// with more words behind it ("fractional, force"); the paper's linear1, linear2 and nonlinear are linear and
/// kuwabara-kono. Words that name none are gray, too.
const char* law_colour(std::string_view words) noexcept;

/// "lc rgb '#0072b2' dt 1": the law's colour, dashed where a title before names the same law, as that of the second end
/// does.
std::string law_line(const std::vector<std::string>& titles, std::size_t at);

}  // namespace ricochet::console
