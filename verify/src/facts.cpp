#include <verify/report.hpp>

#include <console/exit.hpp>
#include <console/plot.hpp>

#include <ricochet/version.hpp>

#include <nlohmann/json.hpp>
#include <nlopt.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <gnu/libc-version.h>
#include <gsl/gsl_version.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>

namespace ricochet::verify {

namespace {

std::string dotted(int a, int b, int c) {
  return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
}

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
  return "Boost " + dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100) +
         ", GSL " GSL_VERSION + ", NLopt " + dotted(major, minor, bugfix) + ", nlohmann-json " +
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH) +
         ", CLI11 " CLI11_VERSION ", glibc " + ::gnu_get_libc_version() + ", gnuplot " + gnuplot();
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
  return ::uname(&name) == 0 ? std::string(name.sysname) + " " + name.release + ", " + name.machine : "unknown";
}

}  // namespace

Facts facts(bool thorough) {
  return {{"version", std::string("Ricochet ") + ricochet::version},
          {"time", timestamp()},
          {"extent", thorough ? "every study, thoroughly" : "every study, without what takes long (--quick)"},
          {"compiler", compiler()},
          {"libraries", libraries()},
          {"machine", machine()}};
}

}  // namespace ricochet::verify
