// Preloaded by locale.sh: gives a program the user's locale before it starts, as a host that embeds the library would.
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>

namespace {

[[gnu::constructor]] void adopt_the_users_locale() {
  std::setlocale(LC_ALL, "");
  std::locale::global(std::locale(""));
  if (std::getenv("SHOW_LOCALE")) std::fprintf(stderr, "%.1f\n", 0.5);
}

}  // namespace
