#pragma once

#include <console/json.hpp>
#include <ricochet/contact/vec3.hpp>

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace ricochet::console {

class Progress;

/// A value of a JSON file that knows its place: every complaint names line, column and JSON path.
class Node {
 public:
  /// `text` is what `json` was parsed from; both outlive the node and its children.
  Node(std::string file, const std::string& text, const Json& json)
      : file_(std::move(file)), text_(&text), json_(&json) {}

  /// Throws BadInput "file:line:column: /path = value: must be <accepted>".
  [[noreturn]] void reject(std::string_view accepted) const;
  /// Throws BadInput "file:line:column: /path: <message>".
  [[noreturn]] void complain(std::string_view message) const;

  /// An object with no key but these.
  void allow(std::span<const std::string_view> keys) const;
  void allow(std::initializer_list<std::string_view> keys) const { allow(std::span(keys.begin(), keys.size())); }
  /// Of an object whose keys are names that tables show: none is empty, holds a control character or begins like a
  /// spreadsheet's formula (= + - @).
  void require_names() const;
  bool has(const std::string& key) const { return json_->is_object() && json_->contains(key); }
  Node at(const std::string& key) const;  ///< missing: "missing; must be given"
  Node at(std::size_t index) const;
  std::size_t size() const;  ///< of an array

  double number() const;  ///< finite
  double positive() const;
  double not_negative() const;
  std::uint64_t integer(std::uint64_t least, std::uint64_t most) const;
  bool yes_or_no() const;
  std::string text() const;  ///< without control characters, which a terminal or a line of a file would obey
  std::string one_of(std::span<const std::string_view> accepted) const;
  std::string one_of(std::initializer_list<std::string_view> accepted) const {
    return one_of(std::span(accepted.begin(), accepted.size()));
  }
  Vec3 vector() const;  ///< [x, y, z]
  const Json& json() const { return *json_; }

 private:
  Node child(const std::string& step, const Json& json) const;
  std::string place() const;  // "file:line:column: /path"

  std::string file_, path_;
  const std::string* text_;
  const Json* json_;
};

/// Parses JSON; syntax errors and repeated keys are reported with line and column. `described_in` is the document that
/// says what such a file holds. `progress`, if any, is advanced by twice the bytes of the text, in pieces of
/// 64 KiB.
Json parse_json(const std::string& file, const std::string& text, std::string_view described_in,
                Progress* progress = nullptr);

}  // namespace ricochet::console
