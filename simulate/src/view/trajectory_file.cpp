#include "trajectory_file.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace ricochet::simulate {
namespace {

using Fields = std::vector<std::string_view>;

// What stands between separators, empty pieces left out.
void split(std::string_view text, char separator, Fields& fields) {
  fields.clear();
  while (!text.empty()) {
    const std::string_view field = text.substr(0, text.find(separator));
    if (!field.empty()) fields.push_back(field);
    text.remove_prefix(std::min(text.size(), field.size() + 1));
  }
}

std::optional<std::size_t> count_in(std::string_view text) {
  std::size_t count = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (status != std::errc{} || end != text.data() + text.size()) return {};
  return count;
}

// The value behind "key=" in a comment line, which is quoted where it holds blanks.
std::string_view value_of(std::string_view comment, std::string_view key) {
  bool quoted = false;
  for (std::size_t at = 0; at < comment.size(); ++at) {
    if (comment[at] == '"') quoted = !quoted;
    const bool begins = !quoted && (at == 0 || comment[at - 1] == ' ');
    if (!begins || !comment.substr(at).starts_with(key)) continue;
    std::string_view value = comment.substr(at + key.size());
    if (!value.starts_with('=')) continue;
    value.remove_prefix(1);
    if (!value.starts_with('"')) return value.substr(0, value.find(' '));
    value.remove_prefix(1);
    return value.substr(0, value.find('"'));
  }
  return {};
}

}  // namespace

TrajectoryFile::TrajectoryFile(std::string path) : path_(std::move(path)), file_(path_, std::ios::binary) {
  if (!file_) throw console::BadInput(path_ + ": cannot be opened; the run must have written it");
  std::string text;
  std::size_t line = 1;
  while (std::getline(file_, text)) {
    const auto grains = count_in(text);
    if (!grains) fail(line, "must be the number of spheres of a frame");
    places_.push_back({file_.tellg(), line + 1, *grains});
    for (std::size_t k = 0; k <= *grains; ++k)
      if (!std::getline(file_, text)) fail(line, fmt::format("the frame of {} spheres is not whole", *grains));
    line += *grains + 2;
  }
  if (places_.empty()) throw console::BadInput(path_ + ": holds no frame");
}

void TrajectoryFile::fail(std::size_t line, std::string_view what) const {
  throw console::BadInput(fmt::format("{}:{}: {}", path_, line, what));
}

TrajectoryFile::Layout TrajectoryFile::layout(std::string_view properties, std::size_t line) const {
  Fields words;
  split(properties, ':', words);
  std::map<std::string_view, std::pair<std::size_t, std::size_t>> found;  // first column and number of columns
  std::size_t columns = 0;
  for (std::size_t k = 0; k + 2 < words.size(); k += 3) {
    const auto width = count_in(words[k + 2]);
    if (!width) fail(line, "Properties: must be name:type:columns, one after the other");
    found[words[k]] = {columns, *width};
    columns += *width;
  }
  const auto place = [&](std::string_view name, std::size_t width, bool needed) {
    const auto at = found.find(name);
    if (at != found.end() && at->second.second == width) return at->second.first;
    if (needed) fail(line, fmt::format("Properties: must hold {} in {} columns", name, width));
    return columns;
  };
  return {place("species", 1, false),
          place("pos", 3, true),
          place("radius", 1, true),
          place("velo", 3, false),
          place("angular_velocity", 3, false),
          place("id", 1, false),
          columns};
}

std::uint32_t TrajectoryFile::number_of(std::string_view species) {
  const auto known = numbers_.find(species);
  if (known != numbers_.end()) return known->second;
  const auto next = static_cast<std::uint32_t>(species_.size());
  species_.emplace_back(species);
  numbers_.emplace(species, next);
  return next;
}

SeenGrain TrajectoryFile::grain(std::string_view row, const Layout& layout, std::size_t line) {
  split(row, ' ', fields_);
  if (fields_.size() != layout.columns)
    fail(line, fmt::format("{} columns: must be {}, as Properties says", fields_.size(), layout.columns));
  const auto number = [&](std::size_t column) {
    const auto value = console::parse_number(fields_[column]);
    if (!value) fail(line, fmt::format("{}: must be a finite number", fields_[column]));
    return *value;
  };
  const auto vector = [&](std::size_t column) {
    return column == layout.columns ? Vec3{} : Vec3{number(column), number(column + 1), number(column + 2)};
  };
  const std::uint32_t species = number_of(layout.species == layout.columns ? "grain" : fields_[layout.species]);
  SeenGrain grain{vector(layout.position), vector(layout.velocity), vector(layout.spin), number(layout.radius),
                  species};
  if (layout.id != layout.columns) {
    const auto id = count_in(fields_[layout.id]);
    if (!id) fail(line, fmt::format("{}: must be a sphere's number", fields_[layout.id]));
    grain.id = *id;
  }
  if (!(grain.radius > 0)) fail(line, "the radius must be > 0");
  return grain;
}

SeenFrame TrajectoryFile::frame(std::size_t number) {
  const Place& place = places_[number];
  file_.clear();
  file_.seekg(place.at);
  std::string text;
  std::getline(file_, text);
  SeenFrame frame;
  const auto time = console::parse_number(value_of(text, "Time"));
  if (!time) fail(place.line, "must hold Time=, a number");
  frame.time = *time;
  const Layout columns = layout(value_of(text, "Properties"), place.line);
  frame.grains.reserve(place.grains);
  for (std::size_t k = 0; k < place.grains; ++k) {
    std::getline(file_, text);
    frame.grains.push_back(grain(text, columns, place.line + 1 + k));
    if (columns.id == columns.columns) frame.grains.back().id = k;
  }
  return frame;
}

}  // namespace ricochet::simulate
