#include <console/manual.hpp>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

using namespace ricochet::console;

namespace {

struct Program {
  CLI::App app{"Tries things.\nAnd more.", "try"};
  std::string text;

  Program() {
    app.add_option("--kind", text, "what kind (default all): all, small (the smaller one), large")->type_name("NAME");
    app.add_option("-o,--output", text, "it's written here")->type_name("FILE");
    app.add_option("--secret", text, "hidden")->group("");
    app.footer("Exit code 0: done.");
  }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a manual page says what --help says, in roff") {
  Program program;
  program.app.add_option("--dots", program.text, ".what begins with a dot \\ is text");
  const std::string page = man_page(program.app);
  CHECK(page.starts_with(".TH TRY 1 "));
  CHECK(has(page, ".SH NAME\ntry \\- Tries things\n"));
  CHECK(has(page, "\n.TP\n\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\nit's written here\n"));
  CHECK(has(page, "\n\\&.what begins with a dot \\e is text\n"));
  CHECK(has(page, ".SH NOTES\nExit code 0: done.\n"));
  CHECK_FALSE(has(page, "secret"));
}

TEST_CASE("a manual page and a completion know a program's commands and their options") {
  Program program;
  program.app.add_subcommand("run", "Runs: once.")->add_option("--often", program.text, "how often");
  const std::string page = man_page(program.app);
  CHECK(has(page, "\\fBtry\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n"));
  CHECK(has(page, ".SH COMMANDS\n.SS \"run\"\nRuns: once.\n"));
  CHECK(has(*completion(program.app, "bash"), "    run)\n      words='-h --help --often'\n"));
  CHECK(has(*completion(program.app, "zsh"), "'run:Runs\\: once'"));
  CHECK(has(*completion(program.app, "fish"), "-n __fish_use_subcommand -a run -d 'Runs: once'"));
}

TEST_CASE("a flag takes no value, in no shell and on no page") {
  Program program;
  program.app.add_flag("--wall")->description("a wall");
  CHECK(has(man_page(program.app), "\n.TP\n\\fB\\-\\-wall\\fR\na wall\n"));
  CHECK(has(*completion(program.app, "zsh"), "'--wall[a wall]'"));
  CHECK(has(*completion(program.app, "fish"), "complete -c try -l wall -d 'a wall'"));
}

TEST_CASE("shells are offered the words that a description lists, and paths") {
  Program program;
  const std::string bash = *completion(program.app, "bash");
  CHECK(has(bash, "--kind) COMPREPLY=($(compgen -W 'all small large' -- \"$word\"))"));
  CHECK(has(bash, "-o|--output) COMPREPLY=($(compgen -f -- \"$word\"))"));
  CHECK_FALSE(has(bash, "secret"));
  const std::string zsh = *completion(program.app, "zsh");
  CHECK(has(zsh, "'--kind[what kind (default all)\\: all, small (the smaller one), large]:word:(all small large)'"));
  CHECK(has(zsh, "'--output[it'\\''s written here]:path:_files'"));
  const std::string fish = *completion(program.app, "fish");
  CHECK(has(fish, "complete -c try -l kind -x -a 'all small large' -d "));
  CHECK(has(fish, "complete -c try -s o -l output -r -F -d 'it\\'s written here'\n"));
  CHECK_FALSE(completion(program.app, "tcsh"));
}
