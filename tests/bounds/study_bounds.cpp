// Runs a study as users do and holds the bounds of its gates, and the orders that it states, against those that were
// written down: whoever loosens one has to do it in both places. And the values: a gate that no longer sees what it is
// about passes, but with another value.
//
//   study_bounds STUDY [ARGUMENT]…     RICOCHET_UPDATE_BOUNDS=1 writes tests/bounds/STUDY.json anew
//
// Exit codes: 0 the study passes and all bounds are those; 1 not so; 2 called otherwise.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

using Json = nlohmann::ordered_json;

namespace {

/// Bounds that a run computes from what it measured move by as much, from machine to machine.
constexpr double measured = 0.02;
/// Values below are rounding; others are what they were: errors, of which a gate says how great they may be, to half of
/// them, as they may come in another order; what has a lower bound, such as an order, to a tenth.
constexpr double rounding = 1e-9, half = 0.5, tenth = 0.1;

std::string output_of(const std::string& command, int& status) {
  std::string text;
  // NOLINTNEXTLINE(cert-env33-c): a program of ours, with the words of a test
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) return status = -1, text;
  char bytes[4096];
  for (std::size_t n = 0; (n = std::fread(bytes, 1, sizeof bytes, pipe)) > 0;) text.append(bytes, n);
  status = ::pclose(pipe);
  return text;
}

/// Name, kind, bound and value of every gate; scheme, function, alpha, stated order and what it may be off by of every
/// row that states an order.
Json bounds_of(const Json& study) {
  Json gates = Json::array(), orders = Json::array();
  for (const Json& gate : study.at("gates"))
    gates.push_back({{"name", gate.at("name")},
                     {"kind", gate.at("kind")},
                     {"bound", gate.at("bound")},
                     {"value", gate.at("value")}});
  for (const Json& row : study.at("rows"))
    if (row.is_object() && row.contains("stated_order") && row.contains("allowed"))
      orders.push_back(
          {row.at("scheme"), row.at("function"), row.at("alpha"), row.at("stated_order"), row.at("allowed")});
  return {{"gates", gates}, {"orders", orders}};
}

bool same(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    const double x = a, y = b;
    return std::abs(x - y) <= measured * std::max(std::abs(x), std::abs(y));
  }
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (!a.is_structured()) return a == b;
  for (auto x = a.begin(), y = b.begin(); x != a.end(); ++x, ++y)
    if (!same(*x, *y) || (a.is_object() && x.key() != y.key())) return false;
  return true;
}

bool same_value(const Json& a, const Json& b, double allowed) {
  if (!a.is_number() || !b.is_number()) return a == b;
  const double x = a, y = b, greater = std::max(std::abs(x), std::abs(y));
  return greater <= rounding || std::abs(x - y) <= allowed * greater;
}

/// Of two bounds on either side of a value: they may lie close together, where two per cent of them are much.
bool same_width(const Json& a, const Json& b) {
  const auto width = [](const Json& bound) { return bound.at(1).get<double>() - bound.at(0).get<double>(); };
  if (!a.is_array() || a.size() != 2 || !b.is_array() || b.size() != 2) return true;
  if (!a[0].is_number() || !a[1].is_number() || !b[0].is_number() || !b[1].is_number()) return true;
  return same(width(a), width(b));
}

bool same_gate(Json a, Json b) {
  if (!a.is_object() || !b.is_object()) return same(a, b);
  if (!same_width(a.at("bound"), b.at("bound"))) return false;
  const bool values = same_value(a.at("value"), b.at("value"), b.at("kind") == "at_most" ? half : tenth);
  a.erase("value"), b.erase("value");
  return values && same(a, b);
}

int compare(const Json& found, const Json& stated) {
  int other = 0;
  for (const char* const what : {"gates", "orders"}) {
    const Json &a = found.at(what), &b = stated.at(what);
    if (a.size() != b.size()) std::printf("%zu %s, not %zu\n", a.size(), what, b.size()), ++other;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
      if (!same_gate(a[k], b[k])) std::printf("%s\nis not\n%s\n", a[k].dump().c_str(), b[k].dump().c_str()), ++other;
  }
  return other;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("usage: study_bounds STUDY [ARGUMENT]...\n", stderr), 2;
  std::string command = RICOCHET_VERIFY;
  for (int k = 1; k < argc; ++k) command += std::string(" ") + argv[k];
  int status = 0;
  const Json study = Json::parse(output_of(command + " --format json", status), nullptr, false);
  if (status != 0 || !study.is_object()) return std::printf("%s: failed\n", command.c_str()), 1;
  const std::string file = std::string(RICOCHET_BOUNDS) + "/" + argv[1] + ".json";
  const Json found = bounds_of(study);
  if (std::getenv("RICOCHET_UPDATE_BOUNDS")) {
    std::ofstream out(file);
    out << "{\"gates\": [";
    for (std::size_t k = 0; k < found["gates"].size(); ++k) out << (k ? ",\n" : "\n") << found["gates"][k].dump();
    out << "],\n\"orders\": [";
    for (std::size_t k = 0; k < found["orders"].size(); ++k) out << (k ? ",\n" : "\n") << found["orders"][k].dump();
    return out << "]}\n", 0;
  }
  std::ifstream in(file);
  const Json stated = Json::parse(std::string(std::istreambuf_iterator<char>(in), {}), nullptr, false);
  if (!stated.is_object()) return std::printf("%s: cannot be read\n", file.c_str()), 1;
  return compare(found, stated) == 0 ? 0 : 1;
}
