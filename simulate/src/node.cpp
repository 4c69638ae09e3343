#include "node.hpp"

#include "place.hpp"

#include <console/exit.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace ricochet::simulate {

using console::BadInput;
using console::Json;

std::string Node::place() const {
  return file_ + ":" + line_and_column(*text_, place_of(*text_, path_)) + ": " + (path_.empty() ? "/" : path_);
}

Node Node::child(const std::string& step, const Json& json) const {
  Node child(file_, *text_, json);
  child.path_ = path_ + "/" + step;
  return child;
}

void Node::reject(std::string_view accepted) const {
  std::string shown = json_->dump();
  if (shown.size() > 60) shown.replace(57, std::string::npos, "...");
  throw BadInput(place() + " = " + shown + ": must be " + std::string(accepted));
}

void Node::complain(std::string_view message) const { throw BadInput(place() + ": " + std::string(message)); }

void Node::allow(std::initializer_list<std::string_view> keys) const {
  std::string accepted;
  for (std::string_view key : keys) accepted += (accepted.empty() ? "" : ", ") + std::string(key);
  if (!json_->is_object()) reject("an object with the keys " + accepted);
  for (const auto& [key, value] : json_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      complain("unknown key \"" + key + "\"; known are " + accepted);
}

Node Node::at(const std::string& key) const {
  if (!has(key)) complain("\"" + key + "\" is missing; it must be given");
  return child(key, json_->at(key));
}

Node Node::at(std::size_t index) const { return child(std::to_string(index), json_->at(index)); }

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
  reject("an integer from " + std::to_string(least) + " to " + std::to_string(most));
}

bool Node::yes_or_no() const {
  if (!json_->is_boolean()) reject("true or false");
  return json_->get<bool>();
}

std::string Node::text() const {
  if (!json_->is_string()) reject("a text");
  return json_->get<std::string>();
}

std::string Node::one_of(std::initializer_list<std::string_view> accepted) const {
  if (json_->is_string() && std::find(accepted.begin(), accepted.end(), json_->get<std::string>()) != accepted.end())
    return text();
  std::string list;
  for (std::string_view word : accepted) list += (list.empty() ? "" : " or ") + std::string(word);
  reject(list);
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

Json parse(const std::string& file, const std::string& text) {
  KeysOnce keys;
  Json json;
  try {
    json = Json::parse(text, std::ref(keys));
  } catch (const Json::parse_error& error) {
    throw BadInput(file + ":" + line_and_column(text, error.byte > 0 ? error.byte - 1 : 0) +
                   ": no JSON: must be one object as docs/scenes.md describes");
  } catch (const Json::out_of_range& error) {  // 406, "number overflow parsing '1e999'"
    const std::string message = error.what();
    const std::size_t first = message.find('\'') + 1, end = message.rfind('\'');
    const std::string number = message.substr(first, end - first);
    throw BadInput(file + ":" + line_and_column(text, text.find(number)) + ": " + number +
                   ": must be at most 1.8e308 in size");
  }
  if (!keys.repeated.empty())
    throw BadInput(file + ": key \"" + keys.repeated + "\" is given twice in one object; it must be given once");
  return json;
}

}  // namespace ricochet::simulate
