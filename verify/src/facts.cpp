#include <verify/report.hpp>

#include <console/exit.hpp>
#include <console/plot.hpp>

#include <ricochet/version.hpp>

#include <nlohmann/json.hpp>
#include <nlopt.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <gsl/gsl_version.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>

namespace ricochet::verify {

namespace {

std::string dotted(int a, int b, int c) { return fmt::format("{}.{}.{}", a, b, c); }

std::string compiler() {
#ifdef __clang__
  return "clang++ " + dotted(__clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return "g++ " + dotted(__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

/// Its absence shows in the studies that draw; the report is written all the same.
std::string gnuplot() {
  try {
    return console::gnuplot_version();
  } catch (const console::Failed&) {
    return "missing";
  }
}

std::string libraries() {
  int major = 0, minor = 0, bugfix = 0;
  ::nlopt_version(&major, &minor, &bugfix);
  return fmt::format(
      "Boost {}, GSL " GSL_VERSION ", NLopt {}, nlohmann-json {}, fmt {}, CLI11 " CLI11_VERSION
      ", glibc {}, gnuplot {}",
      dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100), dotted(major, minor, bugfix),
      dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH),
      dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100), ::gnu_get_libc_version(), gnuplot());
}

/// Now, or the time that reproducible builds set.
std::string timestamp() {
  const char* fixed = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now = fixed ? static_cast<std::time_t>(std::strtoll(fixed, nullptr, 10)) : std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

std::string machine() {
  utsname name{};
  return ::uname(&name) == 0 ? fmt::format("{} {}, {}", name.sysname, name.release, name.machine) : "unknown";
}

}  // namespace

Facts facts(bool thorough) {
  return {{"version", fmt::format("Ricochet {}", ricochet::version)},
          {"time", timestamp()},
          {"extent", thorough ? "every study, thoroughly" : "every study, without what takes long (--quick)"},
          {"compiler", compiler()},
          {"libraries", libraries()},
          {"machine", machine()}};
}

}  // namespace ricochet::verify
