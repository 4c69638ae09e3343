// Every command line in the documents is run, and what it prints is compared. After a wanted change of output:
//   RICOCHET_UPDATE_DOCS=1 build/release/bin/test_docs
// rewrites the documents; read the difference before committing it.

#include "../console/temporary_folder.hpp"
#include "console_blocks.hpp"

#include <ricochet/version.hpp>

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace {

const fs::path root = RICOCHET_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> found;
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
    if (fs::exists(root / name)) found.push_back(root / name);
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

/// The command as this test runs it: the script's set-up left out, so that the programs just built are what runs. Empty
/// for what is not a command of ours, or would run these tests again.
std::string runnable(const std::string& command) {
  static const std::regex program(R"(^(\./ricochet )?(calibrate|verify|simulate) .*)");
  if (!std::regex_match(command, program)) return {};
  return std::regex_replace(command, std::regex(R"((^|[;|&] *)\./ricochet )"), "$1");
}

struct Ran {
  int code;
  std::vector<std::string> lines;
};

Ran run(const std::string& command, const TemporaryFolder& folder) {
  const std::string script = folder / ".command";
  std::ofstream(script) << "cd '" << folder.path().string() << "'\nexport LC_ALL=C.UTF-8 PATH='" << RICOCHET_BIN
                        << "':\"$PATH\"\nexec 2>&1 </dev/null\n"
                        << command << "\n";
  std::FILE* pipe = ::popen(("bash " + script).c_str(), "r");
  std::string printed;
  std::array<char, 4096> chunk{};
  for (std::size_t n = 0; (n = std::fread(chunk.data(), 1, chunk.size(), pipe)) > 0;) printed.append(chunk.data(), n);
  const int status = ::pclose(pipe);
  // How far slow work is, which a busy machine makes it say.
  static const std::regex progress("[a-z ]+: [0-9]+( %, [0-9]+ s left)?");
  auto lines = lines_of(printed);
  std::erase_if(lines, [&](const std::string& line) { return std::regex_match(line, progress); });
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, std::move(lines)};
}

std::vector<std::string> slice(const std::vector<std::string>& lines, std::size_t first, std::size_t last) {
  return {lines.begin() + static_cast<std::ptrdiff_t>(first), lines.begin() + static_cast<std::ptrdiff_t>(last)};
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// What documents name of the checkout.
void link_checkout(const TemporaryFolder& folder) {
  for (const char* name : {"data", "engines", "examples"}) fs::create_directory_symlink(root / name, folder / name);
}

/// Replaces what is documented by what was printed, as far as a closing "…" lets it show.
void update(std::vector<std::string>& lines, const Command& command, std::vector<std::string> printed) {
  const auto documented = slice(lines, command.first_output, command.last_output);
  if (!documented.empty() && documented.back() == "…" && documented.size() <= printed.size()) {
    printed.resize(documented.size() - 1);
    printed.push_back("…");
  }
  const auto at = [&](std::size_t i) { return lines.begin() + static_cast<std::ptrdiff_t>(i); };
  lines.erase(at(command.first_output), at(command.last_output));
  lines.insert(at(command.first_output), printed.begin(), printed.end());
}

/// Every key of the document but those of data (`rows`) and of `units`, whose names are the data's.
void collect_keys(const nlohmann::json& document, std::set<std::string>& keys) {
  if (document.is_array())
    for (const auto& element : document) collect_keys(element, keys);
  if (!document.is_object()) return;
  for (const auto& [key, value] : document.items()) {
    keys.insert(key);
    if (key != "rows" && key != "units") collect_keys(value, keys);
  }
}

}  // namespace

TEST_CASE("every command in the documents does what they say") {
  const bool updating = std::getenv("RICOCHET_UPDATE_DOCS");
  for (const fs::path& document : documents()) {
    const TemporaryFolder folder;  // one a document: a command may use what an earlier one wrote
    link_checkout(folder);
    const auto lines = lines_of(read_file(document));
    auto updated = lines;
    const auto commands = console_commands(lines);
    std::vector<std::pair<Command, std::vector<std::string>>> changed;
    for (const Command& command : commands) {
      const std::string text = runnable(command.text);
      if (text.empty()) continue;
      const Ran ran = run(text, folder);
      INFO(document.string() << ":" << command.first_output << ": $ " << command.text << "\nprints\n"
                             << joined(ran.lines) << "To put this into the document: RICOCHET_UPDATE_DOCS=1 "
                             << RICOCHET_BIN << "/test_docs");
      CHECK(ran.code == command.exit_code);
      const auto documented = slice(lines, command.first_output, command.last_output);
      if (documented.empty() || matches(documented, ran.lines)) continue;
      if (updating)
        changed.emplace_back(command, ran.lines);
      else
        FAIL_CHECK("the document says\n" << joined(documented));
    }
    for (auto change = changed.rbegin(); change != changed.rend(); ++change)
      update(updated, change->first, change->second);
    if (!changed.empty()) std::ofstream(document) << joined(updated);
  }
}

TEST_CASE("every command of ours in a block of shell runs, or where that takes long is understood") {
  // Of these the options alone are looked at.
  static const std::pair<std::regex, const char*> not_run[] = {
      {std::regex("verify (sphere|figures|column|cluster|peers) --figures .*"), "each study is a test of its own"},
      {std::regex("verify engines"), "needs engines, and is a test of its own where they are"},
      {std::regex("verify conformance --results .*"), "reads what engines wrote"},
      {std::regex("simulate data/scenes/.*"), "takes up to a minute"}};
  static const std::regex ours(R"((\./ricochet )?(calibrate|verify|simulate) .*)"), elsewhere("(lmp|liggghts) .*");
  static const std::regex deck(R"(.*\./ricochet (lammps|liggghts) -in (\S+))");
  std::size_t run_whole = 0, understood = 0, decks = 0;
  for (const fs::path& document : documents()) {
    const TemporaryFolder folder;
    link_checkout(folder);
    for (const Command& command : shell_commands(lines_of(read_file(document)))) {
      INFO(document.string() << ":" << command.first_output << ": " << command.text);
      CHECK_FALSE(std::regex_match(command.text, elsewhere));
      if (command.text.find("…") != std::string::npos) continue;
      if (std::smatch match; std::regex_match(command.text, match, deck)) {
        CHECK(fs::exists(root / match[2].str()));
        ++decks;
      }
      if (!std::regex_match(command.text, ours)) continue;
      CHECK(command.text.starts_with("./ricochet "));
      const std::string text = runnable(command.text);
      const bool slow = std::any_of(std::begin(not_run), std::end(not_run),
                                    [&](const auto& kind) { return std::regex_match(text, kind.first); });
      // What a program complains of first is what it does not understand; here that is the last word alone.
      const Ran ran = run(slow ? text + " --an-option-of-none" : text, folder);
      INFO(joined(ran.lines));
      if (slow) {
        CHECK(ran.code == 2);
        CHECK(joined(ran.lines).find("--an-option-of-none") != std::string::npos);
        ++understood;
      } else {
        CHECK(ran.code == 0);
        ++run_whole;
      }
    }
  }
  CHECK(run_whole >= 2);
  CHECK(understood >= 10);
  CHECK(decks >= 4);
}

TEST_CASE("the shell of the job for CI runs, and leaves the files that the job keeps") {
  static const std::regex step(R"(^      - run: (.*)$)"), kept(R"(path: "(\w+)\.\*")");
  const std::string text = read_file(root / "docs/order-gates.md");
  const auto begin = text.find("```yaml\n");
  REQUIRE(begin != std::string::npos);
  const std::string job = text.substr(begin, text.find("\n```\n", begin) - begin);
  const TemporaryFolder folder;
  fs::create_directory_symlink(root / "data", folder / "data");
  std::set<std::string> written;
  for (const std::string& line : lines_of(job))
    if (std::smatch match; std::regex_match(line, match, step)) {
      const Ran ran = run(runnable(match[1].str()), folder);
      INFO(line << "\n" << joined(ran.lines));
      CHECK(ran.code == 0);
      written.insert(line.substr(line.rfind(' ') + 1));
    }
  CHECK(written == std::set<std::string>{"orders.md", "orders.xml"});
  std::smatch pattern;
  REQUIRE(std::regex_search(job, pattern, kept));
  for (const std::string& file : written) CHECK(fs::path(file).stem() == pattern[1].str());
  CHECK(read_file(folder / "orders.md").find("| L1 |") != std::string::npos);
  const std::string junit = read_file(folder / "orders.xml");
  CHECK(junit.find("<testcase") != std::string::npos);
  CHECK(junit.find("<failure") == std::string::npos);
}

TEST_CASE("the README's C++ is the example that the installed library builds") {
  const std::string readme = read_file(root / "README.md");
  CHECK(readme.find("```cpp\n" + read_file(root / "docs/examples/restitution.cpp") + "```\n") != std::string::npos);
}

TEST_CASE("the citation and the newest changes are those of this version") {
  const std::string version = ricochet::version;
  CHECK(read_file(root / "CITATION.cff").find("\nversion: " + version + "\n") != std::string::npos);
  const std::string changes = read_file(root / "CHANGELOG.md");
  std::smatch released;
  REQUIRE(std::regex_search(changes, released, std::regex(R"(\n## \[([0-9.]+)\])")));
  CHECK(released[1].str() == version);
}

TEST_CASE("every key of a JSON document is described") {
  const std::pair<const char*, const char*> documents_of[] = {
      {"calibration", "calibrate --tcol 1e-4 --en 0.001 --law fractional --end both"},
      {"fit", "calibrate --fit data/restitution_ice_bridges1984.csv --alpha-of-speed"},
      {"export", "calibrate --tcol 1e-4 --en 0.5 --law linear --export lammps"},
      {"<study>", "verify table2"}};
  const std::string text = read_file(root / "docs/json.md");
  const TemporaryFolder folder;
  fs::create_directory_symlink(root / "data", folder / "data");
  for (const auto& [kind, command] : documents_of) {
    const auto begin = text.find("## `ricochet/" + std::string(kind) + "/1`");
    REQUIRE(begin != std::string::npos);
    const std::string section = text.substr(begin, text.find("\n## ", begin) - begin);
    std::set<std::string> keys;
    collect_keys(nlohmann::json::parse(joined(run(std::string(command) + " --format json", folder).lines)), keys);
    keys.erase("schema");
    CHECK(keys.size() > 3);
    for (const std::string& key : keys) {
      INFO(command << ": " << key);
      CHECK(std::regex_search(section, std::regex("`" + key + "(\\[\\])?`|[(,] ?" + key + "[,;)]")));
    }
  }
}

TEST_CASE("links between the documents lead somewhere") {
  static const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  for (const fs::path& document : documents()) {
    const std::string text = read_file(document);
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      INFO(document.string() << ": " << (*match)[1].str());
      CHECK(fs::exists(document.parent_path() / (*match)[1].str()));
    }
  }
}

TEST_CASE("console blocks are read as they are meant") {
  const auto lines = lines_of("text\n```console\n$ a \\\n  b\nout\n\nmore\n$ echo $?\n2\n$ c\n```\n$ no\n");
  const auto commands = console_commands(lines);
  REQUIRE(commands.size() == 2);
  CHECK(commands[0].text == "a   b");
  CHECK(slice(lines, commands[0].first_output, commands[0].last_output) == std::vector<std::string>{"out", "", "more"});
  CHECK(commands[0].exit_code == 2);
  CHECK(commands[1].exit_code == 0);
  CHECK_THROWS(console_commands(lines_of("```console\n$ a\n")));
  const auto shell = shell_commands(lines_of("```sh\na 'b#c'   # d\n# e\n```\nf\n```cpp\ng\n```\n```\nh\n```\ni\n"));
  REQUIRE(shell.size() == 2);
  CHECK(shell[0].text == "a 'b#c'");
  CHECK(shell[0].first_output == 2);
  CHECK(shell[1].text == "h");
  CHECK(matches({"a", "b"}, {"a", "b"}));
  CHECK_FALSE(matches({"a"}, {"a", "b"}));
  CHECK_FALSE(matches({"a", "b"}, {"a"}));
  CHECK(matches({"took … s", "…"}, {"took 3.2 s", "x", "y"}));
  CHECK_FALSE(matches({"took … s"}, {"took 3.2 m"}));
  CHECK(matches({"…", "end"}, {"x", "end", "end"}));
}

TEST_CASE("ricochet.hpp includes every public header") {
  const fs::path headers = root / "core/include";
  std::ifstream all(headers / "ricochet/ricochet.hpp");
  const std::string text{std::istreambuf_iterator<char>(all), {}};
  for (const auto& entry : fs::recursive_directory_iterator(headers)) {
    const std::string name = fs::relative(entry.path(), headers).string();
    if (entry.path().extension() != ".hpp" || name == "ricochet/ricochet.hpp" ||
        name.find("/support/") != std::string::npos)
      continue;
    CHECK_THAT(text, Catch::Contains("#include <" + name + ">"));
  }
}
