#include "start.hpp"

#include <console/exit.hpp>
#include <console/input.hpp>
#include <console/number.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

namespace ricochet::simulate {
namespace {

using console::Node;

/// The lines of a text, and which one is read.
class Lines {
 public:
  Lines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

  bool done() const noexcept { return rest_.empty(); }
  std::string_view next() {
    if (rest_.empty()) complain("the frame is cut short; it must have all its spheres");
    ++number_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return line;
  }
  const char* place() const noexcept { return rest_.data(); }
  [[noreturn]] void complain(std::string_view message) const {
    throw console::BadInput(fmt::format("{}:{}: {}", file_, number_, message));
  }

 private:
  std::string file_;
  std::string_view rest_;
  std::size_t number_ = 0;
};

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> all;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) all.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return all;
}

// At which word of a sphere's line each property begins: of "Properties=id:I:1:species:S:1:pos:R:3 …".
std::map<std::string, std::size_t, std::less<>> columns_of(std::string_view comment, const Lines& lines) {
  std::map<std::string, std::size_t, std::less<>> columns;
  const std::string_view key = "Properties=";
  const std::size_t at = comment.find(key);
  if (at == std::string_view::npos) lines.complain("no \"Properties=\"; it must be a trajectory that simulate wrote");
  std::string_view list = comment.substr(at + key.size());
  list = list.substr(0, list.find(' '));
  std::vector<std::string> parts{""};
  for (const char c : list)
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  std::size_t column = 0;
  std::set<std::string, std::less<>> vectors;
  for (std::size_t k = 0; k + 2 < parts.size(); k += 3) {
    const bool vector = console::parse_number(parts[k + 2]) == 3.0;
    if (columns.emplace(parts[k], column).second && vector) vectors.insert(parts[k]);
    column += vector ? 3 : 1;
  }
  for (const auto& [needed, vector] :
       {std::pair("species", false), std::pair("pos", true), std::pair("radius", false), std::pair("mass", false),
        std::pair("velo", true), std::pair("angular_velocity", true)}) {
    if (!columns.contains(needed))
      lines.complain(fmt::format("no property \"{}\"; it must be a trajectory that simulate wrote", needed));
    if (vectors.contains(needed) != vector)
      lines.complain(fmt::format("property \"{}\": must be of {}", needed, vector ? "3 columns" : "1 column"));
  }
  columns.emplace("", column);  // the number of words
  return columns;
}

class Frame {
 public:
  Frame(Lines& lines, const Materials& materials) : lines_(lines), columns_(columns_of(lines.next(), lines)) {
    for (const auto& [name, material] : materials) by_species_.emplace(species(name), material.index);
  }

  Sphere sphere() {
    const auto all = words(lines_.next());
    if (all.size() != columns_.at(""))
      lines_.complain(fmt::format("{} words; must be {}, as the properties say", all.size(), columns_.at("")));
    const auto number = [&](std::size_t column) {
      const auto value = console::parse_number(all[column]);
      if (!value) lines_.complain(fmt::format("{}: must be a number", all[column]));
      return *value;
    };
    const auto vector = [&](const char* name) {
      const std::size_t c = columns_.find(name)->second;
      return Vec3{number(c), number(c + 1), number(c + 2)};
    };
    Sphere s;
    const std::string_view word = all[columns_.find("species")->second];
    const auto material = by_species_.find(word);
    if (material == by_species_.end())
      lines_.complain(fmt::format("{}: must be one of the materials of the scene", word));
    s.material = material->second;
    s.radius = number(columns_.find("radius")->second);
    const double mass = number(columns_.find("mass")->second);
    if (!(s.radius > 0 && mass > 0)) lines_.complain("radius and mass must be > 0");
    s.density = mass / (4.0 / 3 * std::numbers::pi * s.radius * s.radius * s.radius);
    s.position = vector("pos"), s.velocity = vector("velo"), s.spin = vector("angular_velocity");
    return s;
  }

 private:
  Lines& lines_;
  std::map<std::string, std::size_t, std::less<>> columns_;
  std::map<std::string, std::size_t, std::less<>> by_species_;
};

std::size_t count_of(std::string_view line, const Lines& lines) {
  const auto count = console::parse_number(line);
  if (!count || *count < 0 || *count > 1e9 || *count != std::floor(*count))
    lines.complain(fmt::format("{}: must be a number of spheres, as a frame begins", line.substr(0, 60)));
  return static_cast<std::size_t>(*count);
}

}  // namespace

std::string species(const std::string& material) {
  std::string word = material;
  for (char& c : word)
    if (std::isspace(static_cast<unsigned char>(c)) || c == '"' || c == '\'' || c == ',') c = '_';
  return word;
}

std::string read_start(const Node& node, const std::string& scene_file, const Materials& materials, Scene& scene) {
  node.allow({"trajectory", "frame"});
  namespace fs = std::filesystem;
  const std::string path = (fs::path(scene_file).parent_path() / node.at("trajectory").text()).string();
  const std::string text = console::read_input(path);
  constexpr std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t wanted = node.has("frame") ? node.at("frame").integer(0, last - 1) : last;
  // To the frame wanted, or to the last one that is whole.
  Lines lines(path, text), frame = lines;
  std::uint64_t frames = 0;
  for (; !lines.done() && (wanted == last || frames <= wanted); ++frames) {
    frame = lines;
    const std::size_t count = count_of(lines.next(), lines);
    for (std::size_t k = 0; k <= count; ++k) lines.next();
  }
  if (frames == 0) throw console::BadInput(path + ": empty; must be a trajectory that simulate wrote");
  if (wanted != last && frames <= wanted)
    node.at("frame").reject(fmt::format("less than {}, the number of frames in {}", frames, path));
  std::string used(frame.place(), lines.place());
  const std::size_t count = count_of(frame.next(), frame);
  Frame reader(frame, materials);
  scene.setup.spheres.reserve(scene.setup.spheres.size() + count);
  console::Progress progress("read " + path, count);
  for (std::size_t k = 0; k < count; ++k, progress.advance()) scene.setup.spheres.push_back(reader.sphere());
  return used;
}

}  // namespace ricochet::simulate
