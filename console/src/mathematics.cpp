#include <console/html.hpp>

#include <cctype>
#include <optional>

// Mathematics as people type it, made what people write. Works on text that is escaped already: markup characters have
// become entities, so that none of the signs below is part of a tag.

namespace ricochet::console {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// The text between `at`, where a bracket opens, and its partner; nullopt where there is none.
std::optional<std::string_view> bracketed(std::string_view text, std::size_t at) {
  const char open = text[at], close = open == '{' ? '}' : ')';
  int depth = 0;
  for (std::size_t i = at; i < text.size(); ++i) {
    depth += text[i] == open ? 1 : text[i] == close ? -1 : 0;
    if (depth == 0) return text.substr(at + 1, i - at - 1);
  }
  return std::nullopt;
}

struct Symbol {
  std::string_view word, html;
};
constexpr Symbol symbols[] = {
    {"alpha", "α"}, {"beta0", "<i>β</i><sub>0</sub>"}, {"en", "<i>e</i><sub>n</sub>"}, {"mu", "μ"},
    {"nu", "ν"},    {"tcol", "<i>t</i><sub>col</sub>"}};

/// The symbol whose name begins at `at`; nullptr where a longer name does.
const Symbol* symbol_at(std::string_view text, std::size_t at) {
  for (const Symbol& symbol : symbols) {
    const std::size_t end = at + symbol.word.size();
    if (text.substr(at).starts_with(symbol.word) && (end >= text.size() || text[end] == '-' || !is_word(text[end])))
      return &symbol;
  }
  return nullptr;
}

/// What of `text` from `at` on makes an exponent without brackets: a sign and digits, a symbol's name, or one letter.
std::size_t bare_exponent(std::string_view text, std::size_t at) {
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
  };
  std::size_t end = at;
  if (text.substr(end).starts_with("−"))
    end += std::string_view("−").size();
  else if (end < text.size() && text[end] == '-')
    ++end;
  const std::size_t digits = end;
  while (is_digit(end)) ++end;
  if (end > digits && end < text.size() && text[end] == '.' && is_digit(end + 1))
    for (++end; is_digit(end);) ++end;
  if (end > digits) return end - at;
  if (digits > at || at >= text.size()) return 0;
  if (const Symbol* const symbol = symbol_at(text, at)) return symbol->word.size();
  if (is_ascii(text[at])) return std::isalpha(static_cast<unsigned char>(text[at])) ? 1 : 0;
  std::size_t letter = 1;  // of several bytes
  while (at + letter < text.size() && (static_cast<unsigned char>(text[at + letter]) & 0xC0) == 0x80) ++letter;
  return letter;
}

class Writer {
 public:
  enum class Kind { prose, formula };  // a hyphen of a formula is a minus

  explicit Writer(std::string_view text, Kind kind = Kind::prose) : text_(text), kind_(kind) {}

  std::string html() {
    while (at_ < text_.size())
      if (!exponent() && !index() && !power_of_ten() && !symbol() && !minus()) html_ += text_[at_++];
    return html_;
  }

 private:
  bool is_minus(std::size_t at) const { return kind_ == Kind::formula && text_[at] == '-'; }
  bool begins_word() const { return at_ == 0 || !is_word(text_[at_ - 1]) || is_minus(at_ - 1); }

  bool minus() {
    if (!is_minus(at_)) return false;
    html_ += "−";
    ++at_;
    return true;
  }

  /// x^2, x^{1−α}, s^(alpha-2)
  bool exponent() {
    if (text_[at_] != '^' || at_ + 1 >= text_.size()) return false;
    const char next = text_[at_ + 1];
    if (next == '{' || next == '(') {
      const auto inner = bracketed(text_, at_ + 1);
      if (!inner) return false;
      html_ += "<sup>" + Writer(*inner, Kind::formula).html() + "</sup>";
      at_ += inner->size() + 3;
      return true;
    }
    const std::size_t length = bare_exponent(text_, at_ + 1);
    if (length == 0) return false;
    html_ += "<sup>" + Writer(text_.substr(at_ + 1, length), Kind::formula).html() + "</sup>";
    at_ += 1 + length;
    return true;
  }

  /// e_n, t_col, k_t: one letter of its own with up to four characters below it.
  bool index() {
    if (!std::isalpha(static_cast<unsigned char>(text_[at_])) || !begins_word()) return false;
    if (at_ + 2 >= text_.size() || text_[at_ + 1] != '_') return false;
    std::size_t end = at_ + 2;
    while (end < text_.size() && std::isalnum(static_cast<unsigned char>(text_[end]))) ++end;
    if (end == at_ + 2 || end > at_ + 6 || (end < text_.size() && text_[end] == '_')) return false;
    html_ +=
        "<i>" + std::string(1, text_[at_]) + "</i><sub>" + std::string(text_.substr(at_ + 2, end - at_ - 2)) + "</sub>";
    at_ = end;
    return true;
  }

  /// Ten to a power needs no "1·" before it.
  bool follows_lone_one() const {
    if (!html_.ends_with('1')) return false;
    return at_ == 1 || (!std::isalnum(static_cast<unsigned char>(text_[at_ - 2])) && text_[at_ - 2] != '.');
  }

  /// 8.8e-02 after its digits
  bool power_of_ten() {
    if (text_[at_] != 'e' || at_ == 0 || !std::isdigit(static_cast<unsigned char>(text_[at_ - 1]))) return false;
    std::size_t end = at_ + 1;
    const bool negative = end < text_.size() && text_[end] == '-';
    if (end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
    std::size_t last = end;
    while (last < text_.size() && std::isdigit(static_cast<unsigned char>(text_[last]))) ++last;
    if (last == end || (last < text_.size() && (is_word(text_[last]) || !is_ascii(text_[last])))) return false;
    while (end + 1 < last && text_[end] == '0') ++end;
    if (follows_lone_one())
      html_.pop_back();
    else
      html_ += "·";
    html_ += "10<sup>" + std::string(negative ? "−" : "") + std::string(text_.substr(end, last - end)) + "</sup>";
    at_ = last;
    return true;
  }

  /// alpha, tcol, en: a word that is a symbol's name, but not in a flag or in a longer name.
  bool symbol() {
    const Symbol* const symbol = begins_word() ? symbol_at(text_, at_) : nullptr;
    if (!symbol) return false;
    html_ += symbol->html;
    at_ += symbol->word.size();
    return true;
  }

  std::string_view text_;
  Kind kind_;
  std::size_t at_ = 0;
  std::string html_;
};

}  // namespace

std::string html_text(std::string_view text) {
  const std::string safe = escaped(text);
  return Writer(safe).html();
}

}  // namespace ricochet::console
