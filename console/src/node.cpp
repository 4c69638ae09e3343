#include <console/node.hpp>

#include "place.hpp"

#include <console/exit.hpp>
#include <console/harmless.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
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

void Node::require_names() const {
  for (const auto& [key, value] : json_->items())
    if (key.empty() || !is_harmless(key))
      child(key, value).complain("must have a name of printable characters that begins with none of = + - @");
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
  if (!json_->is_string() || has_controls(json_->get_ref<const std::string&>()))
    reject("a text without control characters");
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

/// More than any scene or state needs, and far less than what the recursions over a document would run out of stack by.
constexpr std::size_t deepest = 64;

/// Before the parser sees it: what follows the text is no matter of a bracket more or less.
void require_shallow(const std::string& file, const std::string& text) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted && c == '\\')
      ++at;
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && (c == '[' || c == '{') && ++depth > deepest)
      throw BadInput(fmt::format("{}:{}: brackets in more than {} brackets; must be fewer", file,
                                 line_and_column(text, at), deepest));
    else if (!quoted && (c == ']' || c == '}') && depth > 0)
      --depth;
  }
}

/// Through a text, which tells of every 64 KiB.
class Told {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Told() = default;
  Told(const char* at, std::size_t length, Progress* progress) : at_(at), left_(length), progress_(progress) {}

  reference operator*() const { return *at_; }
  Told& operator++() {
    ++at_, --left_;
    if (left_ % piece == 0 && progress_) progress_->advance(piece);
    return *this;
  }
  bool operator==(const Told& other) const { return at_ == other.at_; }

 private:
  static constexpr std::size_t piece = 1 << 16;
  const char* at_ = nullptr;
  std::size_t left_ = 0;
  Progress* progress_ = nullptr;
};

/// JSON lets a key come twice and readers keep the last: in a scene that is a mistake. A pass of its own: the library's
/// parser with a callback looks through a whole array at the end of each of its elements.
class KeysOnce final : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

  bool start_object(std::size_t) override {
    seen_.emplace_back();
    return true;
  }
  bool key(string_t& name) override {
    if (seen_.back().insert(name).second) return true;
    repeated = name;
    return false;
  }
  bool end_object() override {
    seen_.pop_back();
    return true;
  }

  std::string repeated;

 private:
  std::vector<std::set<std::string>> seen_;
};

}  // namespace

Json parse_json(const std::string& file, const std::string& text, std::string_view described_in, Progress* progress) {
  require_shallow(file, text);
  const Told begin(text.data(), text.size(), progress), end(text.data() + text.size(), 0, nullptr);
  Json json;
  try {
    json = Json::parse(begin, end);
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
  if (KeysOnce keys; !Json::sax_parse(begin, end, &keys))
    throw BadInput(
        fmt::format("{}: key \"{}\" is given twice in one object; it must be given once", file, keys.repeated));
  return json;
}

}  // namespace ricochet::console
