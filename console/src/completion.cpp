#include "option_names.hpp"

#include <console/manual.hpp>

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace ricochet::console {

namespace {

/// What a shell is told of one option.
struct Word {
  std::vector<std::string> flags;
  std::string what;                  ///< its description
  bool value = false, path = false;  ///< takes one; and that is a file or folder
  std::vector<std::string> choices = {};
};

/// "a, b or c" behind the last colon of a description, remarks in brackets left out; "table (default), json or csv" has
/// no colon. Nothing where that is a sentence.
std::vector<std::string> choices_in(const std::string& description) {
  const auto colon = description.rfind(": ");
  std::string list = colon == std::string::npos ? description : description.substr(colon + 2), word;
  std::vector<std::string> all;
  int depth = 0;
  for (const char c : list + ",") {
    depth += (c == '(') - (c == ')');
    if (depth > 0 || c == ')') continue;
    if (c != ',' || word.empty()) {
      word += c;
      continue;
    }
    for (std::size_t at = 0; at != std::string::npos;) {
      const std::size_t next = word.find(" or ", at);
      std::string one = word.substr(at, next == std::string::npos ? next : next - at);
      at = next == std::string::npos ? next : next + 4;
      one.erase(0, one.find_first_not_of(' '));
      one.erase(one.find_last_not_of(' ') + 1);
      if (one.empty()) continue;
      if (one.find(' ') != std::string::npos) return {};
      all.push_back(one);
    }
    word.clear();
  }
  return all.size() > 1 ? all : std::vector<std::string>{};
}

std::vector<Word> words_of(const CLI::App& app) {
  std::vector<Word> words;
  for (const CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    Word word{.flags = flags_of(*option), .what = option->get_description(), .value = takes_value(*option)};
    if (word.flags.empty() || option->get_group().empty()) continue;
    word.path = type.starts_with("FILE") || type == "DIR";
    if (type == "NAME" || type == "FORMAT") word.choices = choices_in(word.what);
    words.push_back(word);
  }
  return words;
}

std::string all_flags(const std::vector<Word>& words) {
  std::vector<std::string> flags;
  for (const Word& word : words) flags.insert(flags.end(), word.flags.begin(), word.flags.end());
  return fmt::format("{}", fmt::join(flags, " "));
}

std::string names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return fmt::format("{}", fmt::join(names, " "));
}

/// The cases of what may follow one of these flags.
std::string bash_values(const std::vector<Word>& words, const std::string& indent) {
  std::string text;
  for (const Word& word : words)
    if (word.path || !word.choices.empty())
      text += fmt::format("{}{}) {} ;;\n", indent, fmt::join(word.flags, "|"),
                          word.path ? "COMPREPLY=($(compgen -f -- \"$word\")) && return"
                                    : fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\")) && return",
                                                  fmt::join(word.choices, " ")));
  return text;
}

std::string bash_completion(const CLI::App& app) {
  const auto commands = commands_of(app);
  const std::string& name = app.get_name();
  std::string text = fmt::format("# bash completion of {0}\n_ricochet_{0}() {{\n", name);
  text += "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words files=-f\n  COMPREPLY=()\n";
  const auto branch = [&](const CLI::App& of, const std::string& indent) {
    const auto words = words_of(of);
    const std::string values = bash_values(words, indent + "  ");
    if (!values.empty()) text += fmt::format("{0}case $before in\n{1}{0}esac\n", indent, values);
    text += fmt::format("{}words='{}'\n", indent, all_flags(words));
  };
  if (commands.empty()) {
    branch(app, "  ");
  } else {
    text += "  case ${COMP_WORDS[1]} in\n";
    for (const CLI::App* command : commands) {
      text += fmt::format("    {})\n", command->get_name());
      branch(*command, "      ");
      text += "      ;;\n";
    }
    text += fmt::format("    *) words='{} {}' ;;\n  esac\n", names_of(commands), all_flags(words_of(app)));
    text += "  ((COMP_CWORD > 1)) || files=\n";
  }
  text += "  COMPREPLY=($(compgen -W \"$words\" ${files:+$([[ $word == -* ]] || echo \"$files\")} -- \"$word\"))\n}\n";
  return text + fmt::format("complete -o filenames -F _ricochet_{0} {0}\n", name);
}

/// In single quotes, as zsh's _arguments and fish read a description.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':')
      out += fmt::format("\\{}", c);
    else
      out += c;
  return out;
}

std::string zsh_arguments(const std::vector<Word>& words, const std::string& indent) {
  std::string text;
  for (const Word& word : words)
    for (const std::string& flag : word.flags) {
      text += fmt::format(" \\\n{}'{}[{}]", indent, flag, quoted(word.what));
      if (word.value)
        text += word.path              ? ":path:_files"
                : word.choices.empty() ? ":value:"
                                       : fmt::format(":word:({})", fmt::join(word.choices, " "));
      text += "'";
    }
  return text;
}

std::string zsh_completion(const CLI::App& app) {
  const auto commands = commands_of(app);
  std::string text = fmt::format("#compdef {}\n", app.get_name());
  if (commands.empty())
    return text + fmt::format("_arguments{} \\\n  '*:file:_files'\n", zsh_arguments(words_of(app), "  "));
  text += "if (( CURRENT == 2 )); then\n  local -a commands\n  commands=(\n";
  for (const CLI::App* command : commands)
    text += fmt::format("    '{}:{}'\n", command->get_name(), quoted(first_line(command->get_description())));
  text += "  )\n  _describe command commands\n  return\nfi\nlocal command=$words[2]\nshift words\n(( CURRENT-- ))\n";
  text += "case $command in\n";
  for (const CLI::App* command : commands)
    text += fmt::format("  {}) _arguments{} \\\n    '*:file:_files' ;;\n", command->get_name(),
                        zsh_arguments(words_of(*command), "    "));
  return text + "esac\n";
}

std::string fish_quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
  return out;
}

std::string fish_options(const std::string& program, const std::string& when, const std::vector<Word>& words) {
  std::string text;
  for (const Word& word : words) {
    text += fmt::format("complete -c {}{}", program, when);
    for (const std::string& flag : word.flags)
      text += flag.starts_with("--") ? fmt::format(" -l {}", flag.substr(2)) : fmt::format(" -s {}", flag.substr(1));
    if (word.value) text += word.path ? " -r -F" : " -x";
    if (!word.choices.empty()) text += fmt::format(" -a '{}'", fmt::join(word.choices, " "));
    text += fmt::format(" -d '{}'\n", fish_quoted(word.what));
  }
  return text;
}

std::string fish_completion(const CLI::App& app) {
  const std::string& name = app.get_name();
  const auto commands = commands_of(app);
  std::string text = fmt::format("# fish completion of {}\n", name);
  if (commands.empty()) return text + fish_options(name, "", words_of(app));
  for (const CLI::App* command : commands)
    text += fmt::format("complete -c {} -f -n __fish_use_subcommand -a {} -d '{}'\n", name, command->get_name(),
                        fish_quoted(first_line(command->get_description())));
  for (const CLI::App* command : commands)
    text += fish_options(name, fmt::format(" -n '__fish_seen_subcommand_from {}'", command->get_name()),
                         words_of(*command));
  return text;
}

}  // namespace

std::optional<std::string> completion(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return bash_completion(app);
  if (shell == "zsh") return zsh_completion(app);
  if (shell == "fish") return fish_completion(app);
  return std::nullopt;
}

}  // namespace ricochet::console
