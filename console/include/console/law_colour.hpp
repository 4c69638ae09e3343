#pragma once

#include <string_view>

namespace ricochet::console {

/// The colour of a law in every picture, of the palette: one a law, however many are drawn. By its name, or the name
/// with more words behind it ("fractional, force"); the paper's linear1, linear2 and nonlinear are linear and
/// kuwabara-kono. Words that name none are gray, too.
const char* law_colour(std::string_view words) noexcept;

}  // namespace ricochet::console
