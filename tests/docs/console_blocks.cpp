#include "console_blocks.hpp"

#include <sstream>
#include <stdexcept>

namespace {

const std::string anything = "…";

/// `documented` with "…" for any text against the whole of `printed`.
bool line_matches(const std::string& documented, const std::string& printed) {
  const auto gap = documented.find(anything);
  if (gap == std::string::npos) return documented == printed;
  if (printed.compare(0, gap, documented, 0, gap) != 0) return false;
  const std::string rest = documented.substr(gap + anything.size());
  for (std::size_t start = gap; start <= printed.size(); ++start)
    if (line_matches(rest, printed.substr(start))) return true;
  return false;
}

bool lines_match(const std::vector<std::string>& documented, std::size_t i, const std::vector<std::string>& printed,
                 std::size_t j) {
  for (; i < documented.size(); ++i, ++j) {
    if (documented[i] == anything) {
      for (std::size_t k = j; k <= printed.size(); ++k)
        if (lines_match(documented, i + 1, printed, k)) return true;
      return false;
    }
    if (j >= printed.size() || !line_matches(documented[i], printed[j])) return false;
  }
  return j == printed.size();
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<Command> console_commands(const std::vector<std::string>& lines) {
  std::vector<Command> commands;
  bool inside = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (!inside) {
      inside = line == "```console";
      continue;
    }
    if (line == "```") {
      inside = false;
    } else if (line == "$ echo $?") {
      if (commands.empty() || i + 1 == lines.size())
        throw std::runtime_error("line " + std::to_string(i + 1) + ": no command before echo $?");
      commands.back().exit_code = std::stoi(lines[++i]);
    } else if (line.starts_with("$ ")) {
      std::string text = line.substr(2);
      while (text.ends_with('\\') && i + 1 < lines.size()) text = text.substr(0, text.size() - 1) + lines[++i];
      commands.push_back({text, i + 1, i + 1});
    } else if (!commands.empty()) {
      commands.back().last_output = i + 1;
    } else {
      throw std::runtime_error("line " + std::to_string(i + 1) + ": output before any command");
    }
  }
  if (inside) throw std::runtime_error("a console block is not closed");
  return commands;
}

std::vector<Command> shell_commands(const std::vector<std::string>& lines) {
  std::vector<Command> commands;
  bool inside = false, shell = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.starts_with("```")) {
      shell = !inside && (line == "```sh" || line == "```");
      inside = !inside;
    } else if (shell) {
      std::string text = line.substr(0, line.find(" #"));
      text.erase(text.find_last_not_of(' ') + 1);
      if (!text.empty() && text[0] != '#') commands.push_back({text, i + 1, i + 1});
    }
  }
  return commands;
}

bool matches(const std::vector<std::string>& documented, const std::vector<std::string>& printed) {
  return lines_match(documented, 0, printed, 0);
}
