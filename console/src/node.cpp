#include <console/node.hpp>

#include "place.hpp"

#include <console/exit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace ricochet::console {

std::string Node::place() const {
  return fmt::format("{}:{}: {}", file_, line_and_column(*text_, place_of(*text_, path_)), path_.empty() ? "/" : path_);
}

Node Node::child(const std::string& step, const Json& json) const {
  Node child(file_, *text_, json);
  child.path_ = fmt::format("{}/{}", path_, step);
  return child;
}

void Node::reject(std::string_view accepted) const {
  std::string shown = json_->dump();
  if (shown.size() > 60) shown.replace(57, std::string::npos, "...");
  throw BadInput(fmt::format("{} = {}: must be {}", place(), shown, accepted));
}

void Node::complain(std::string_view message) const { throw BadInput(fmt::format("{}: {}", place(), message)); }

void Node::allow(std::span<const std::string_view> keys) const {
  const std::string accepted = fmt::format("{}", fmt::join(keys, ", "));
  if (!json_->is_object()) reject(fmt::format("an object with the keys {}", accepted));
  for (const auto& [key, value] : json_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      complain(fmt::format("unknown key \"{}\"; known are {}", key, accepted));
}

Node Node::at(const std::string& key) const {
  if (!has(key)) complain(fmt::format("\"{}\" is missing; it must be given", key));
  return child(key, json_->at(key));
}

Node Node::at(std::size_t index) const { return child(fmt::format_int(index).str(), json_->at(index)); }

std::size_t Node::size() const {
  if (!json_->is_array()) reject("an array");
  return json_->size();
}

double Node::number() const {
  if (!json_->is_number() || !std::isfinite(json_->get<double>())) reject("a finite number");
  return json_->get<double>();
}

double Node::positive() const {
  if (!json_->is_number() || !(number() > 0)) reject("a number > 0");
  return number();
}

double Node::not_negative() const {
  if (!json_->is_number() || !(number() >= 0)) reject("a number >= 0");
  return number();
}

std::uint64_t Node::integer(std::uint64_t least, std::uint64_t most) const {
  if (json_->is_number_unsigned() && json_->get<std::uint64_t>() >= least && json_->get<std::uint64_t>() <= most)
    return json_->get<std::uint64_t>();
  reject(fmt::format("an integer from {} to {}", least, most));
}

bool Node::yes_or_no() const {
  if (!json_->is_boolean()) reject("true or false");
  return json_->get<bool>();
}

std::string Node::text() const {
  if (!json_->is_string()) reject("a text");
  return json_->get<std::string>();
}

std::string Node::one_of(std::span<const std::string_view> accepted) const {
  if (json_->is_string() && std::find(accepted.begin(), accepted.end(), json_->get<std::string>()) != accepted.end())
    return text();
  reject(fmt::format("{}", fmt::join(accepted, " or ")));
}

Vec3 Node::vector() const {
  if (!json_->is_array() || json_->size() != 3) reject("three numbers [x, y, z]");
  return {at(0).number(), at(1).number(), at(2).number()};
}

namespace {

// JSON lets a key come twice and readers keep the last: in a scene that is a mistake. The callback sees every key
// together with its depth.
class KeysOnce {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) seen_.resize(static_cast<std::size_t>(depth) + 1);
    if (event != Json::parse_event_t::key) return true;
    const auto level = static_cast<std::size_t>(depth);
    if (seen_.size() <= level) seen_.resize(level + 1);
    if (!seen_[level].insert(value.get<std::string>()).second && repeated.empty()) repeated = value.get<std::string>();
    return true;
  }
  std::string repeated;

 private:
  std::vector<std::set<std::string>> seen_;
};

}  // namespace

Json parse_json(const std::string& file, const std::string& text, std::string_view described_in) {
  KeysOnce keys;
  Json json;
  try {
    json = Json::parse(text, std::ref(keys));
  } catch (const Json::parse_error& error) {
    throw BadInput(fmt::format("{}:{}: no JSON: must be one object as {} describes", file,
                               line_and_column(text, error.byte > 0 ? error.byte - 1 : 0), described_in));
  } catch (const Json::out_of_range& error) {  // 406, "number overflow parsing '1e999'"
    const std::string message = error.what();
    const std::size_t first = message.find('\'') + 1, end = message.rfind('\'');
    const std::string number = message.substr(first, end - first);
    throw BadInput(fmt::format("{}:{}: {}: must be at most 1.8e308 in size", file,
                               line_and_column(text, text.find(number)), number));
  }
  if (!keys.repeated.empty())
    throw BadInput(
        fmt::format("{}: key \"{}\" is given twice in one object; it must be given once", file, keys.repeated));
  return json;
}

}  // namespace ricochet::console
