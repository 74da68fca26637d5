// The manual page and what shells complete: all that the help describes is in each of them.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Names = std::set<std::string>;

class Manual : public ProgramTest {
 protected:
  /// Returns what is printed by `rotatebook help` with `options`.
  std::string helpOf(std::vector<std::string> options) const {
    options.insert(options.begin(), "help");
    const ChildResult result = run(options);
    EXPECT_EQ(result.status, 0) << result.error;
    return result.output;
  }

  /// Returns the first words of the lines that are two columns in, below `heading` or anywhere.
  static Names firstWords(const std::string& help, const std::string& heading = "") {
    Names names;
    std::istringstream lines(help);
    bool isBelow = heading.empty();
    for (std::string line; std::getline(lines, line);) {
      if (!heading.empty() && (line.empty() || line == heading)) isBelow = !line.empty();
      if (isBelow && line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
        names.insert(line.substr(2, line.find(' ', 2) - 2));
    }
    return names;
  }

  /// Returns each command with its options and their dashes, as the help has them.
  std::map<std::string, Names> commands() const {
    std::map<std::string, Names> all;
    for (const std::string& command : firstWords(helpOf({}), "Commands:")) {
      for (const std::string& words : firstWords(helpOf({command}))) {
        std::istringstream names(words[0] == '-' ? words : "");
        for (std::string name; std::getline(names, name, ',');) all[command].insert(name);
      }
    }
    return all;
  }

  /// Returns the part of `text` from `begin` up to `end`.
  static std::string part(const std::string& text, const std::string& begin,
                          const std::string& end) {
    const std::size_t from = text.find(begin);
    EXPECT_NE(from, text.npos) << begin;
    return from == text.npos ? "" : text.substr(from, text.find(end, from + 1) - from);
  }

  /// Expects no complaint of a program about the file; skips it where the program is lacking.
  void expectAccepted(const std::string& command) const {
    const std::string program = command.substr(0, command.find(' '));
    if (shell("command -v " + program).status != 0) return;
    const ChildResult result = shell(command);
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_THAT(result.output + result.error, IsEmpty()) << command;
  }

  ChildResult shell(const std::string& line) const {
    return runChild("/bin/bash", {"-c", line}, {.folder = folder()});
  }

  /// Returns what bash offers for the last of `words`.
  std::string completed(const std::string& words) const {
    return shell("source <('" ROTATEBOOK_PROGRAM "' help --completion bash); COMP_WORDS=(" + words +
                 "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); $(complete -p rotatebook | "
                 "sed 's/.*-F \\([^ ]*\\).*/\\1/'); echo \"${COMPREPLY[*]}\"")
        .output;
  }
};

TEST_F(Manual, PageHasEachCommandAndOption) {
  const std::string page = helpOf({"--man"});
  const std::string ofProgram = part(page, ".SH OPTIONS", ".SH COMMANDS");
  const auto all = commands();
  ASSERT_THAT(all, SizeIs(::testing::Ge(20)));
  for (const auto& [command, options] : all) {
    const std::string section = part(page, ".SS " + command + "\n", "\n.S");
    EXPECT_THAT(section, HasSubstr("rotatebook " + command + "\\fR [OPTIONS]"));
    for (const std::string& option : options) {
      const std::string name = "\\fB" + std::regex_replace(option, std::regex("-"), "\\-") + "\\fR";
      EXPECT_THAT(section + ofProgram, HasSubstr(name)) << command;
    }
  }
}

TEST_F(Manual, CompletionsHaveEachCommandAndOption) {
  const std::string bash = helpOf({"--completion", "bash"});
  const std::string zsh = helpOf({"--completion", "zsh"});
  const std::string fish = helpOf({"--completion", "fish"});
  EXPECT_THAT(zsh, AllOf(HasSubstr("'1: :(render map study)'"), HasSubstr(": :(rad/s deg/s)'")));
  EXPECT_THAT(fish, AllOf(HasSubstr("from submit' -a 'render map study'"),
                          HasSubstr("-l rates -r -f -a 'rad/s deg/s'")));
  for (const auto& [command, options] : commands()) {
    SCOPED_TRACE(command);
    EXPECT_THAT(part(bash, "\"\") words='", ";;"), ContainsRegex("[' ]" + command + " "));
    EXPECT_THAT(zsh, HasSubstr("\n    '" + command + ":"));
    EXPECT_THAT(fish, HasSubstr("-f -a " + command + " -d"));
    const std::string ofBash = part(bash, "\n    " + command + ") ", "\n");
    const std::string ofZsh = part(zsh, "\n    " + command + ") ", ";;");
    for (const std::string& option : options) {
      const bool isLong = option.starts_with("--");
      EXPECT_THAT(ofBash, ContainsRegex("[' ]" + option + "[' ]"));
      EXPECT_THAT(ofZsh, HasSubstr("'*" + option + "["));
      EXPECT_THAT(fish, ContainsRegex(
                            "from " + command + "'.* " +
                            (isLong ? "-l " + option.substr(2) : "-s " + option.substr(1)) + " "));
    }
  }
}

TEST_F(Manual, BashCompletes) {
  EXPECT_EQ(completed("rotatebook ren"), "render\n");
  EXPECT_EQ(completed("rotatebook render --overw"), "--overwrite\n");
  EXPECT_EQ(completed("rotatebook -q render my.toml --no-p"), "--no-png\n");
  EXPECT_EQ(completed("rotatebook help doc"), "doctor\n");
  EXPECT_EQ(completed("rotatebook submit ''"), "render map study\n");
  EXPECT_EQ(completed("rotatebook submit render m"), "\n") << "a scene comes after the work";
  EXPECT_EQ(completed("rotatebook submit --slurm ''"), "render map study\n");
  EXPECT_EQ(completed("rotatebook submit -o out m"), "map\n");
  EXPECT_EQ(completed("rotatebook submit render --plan ''"), "list parallel\n");
  EXPECT_EQ(completed("rotatebook render --progress j"), "json\n");
  EXPECT_EQ(completed("rotatebook info --unit m"), "m mm\n");
  EXPECT_EQ(completed("rotatebook page --language g"), "german\n");
  EXPECT_EQ(completed("rotatebook still --device s"), "software\n");
  EXPECT_EQ(completed("rotatebook render my.toml --format w"), "webm\n");
  EXPECT_EQ(completed("rotatebook toss my.csv --rates d"), "deg/s\n");
  EXPECT_EQ(completed("rotatebook doctor --overw"), "\n");  // Another command's.
  EXPECT_EQ(completed("rotatebook render my"), "\n");       // Bash's own files follow.
}

TEST_F(Manual, BashCompletesScenesAndFolders) {
  for (const char* name : {"my.toml", "my.csv"}) write(name, "");
  fs::create_directory(folder() / "myths");
  EXPECT_EQ(completed("rotatebook render my"), "my.toml myths\n");
  EXPECT_EQ(completed("rotatebook submit render --slurm my"), "my.toml myths\n");
  EXPECT_EQ(completed("rotatebook render -o my"), "\n");  // Bash's own files follow.
  EXPECT_EQ(completed("rotatebook verify my"), "\n");     // Likewise.
}

TEST_F(Manual, FishCompletes) {
  if (shell("command -v fish").status != 0) GTEST_SKIP() << "there is no fish";
  write("fish", helpOf({"--completion", "fish"}));
  for (const char* name : {"my.toml", "my.csv"}) write(name, "");
  const auto offered = [this](const std::string& line) {
    return shell("HOME=$PWD fish --no-config -c 'source ./fish; complete -C \"" + line +
                 "\"' | cut -f 1 | tr '\\n' ' '")
        .output;
  };
  EXPECT_EQ(offered("rotatebook ren"), "render ");
  EXPECT_EQ(offered("rotatebook submit --plan l"), "list ");
  EXPECT_EQ(offered("rotatebook toss my.csv --rates d"), "deg/s ");
  EXPECT_EQ(offered("rotatebook page --language g"), "german ");
  EXPECT_THAT(offered("rotatebook render my"), ::testing::StartsWith("my.toml "));
}

TEST_F(Manual, ZshCompletes) {
  if (shell("command -v zsh").status != 0) GTEST_SKIP() << "there is no zsh";
  write("zsh", helpOf({"--completion", "zsh"}));
  for (const char* name : {"my.toml", "my.csv"}) write(name, "");
  // It completes in a terminal alone, and puts what is the only match into the line
  write("try", R"(zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z 'PS1=; autoload -U compinit; compinit -u -D; source ./zsh'
zpty -w z 'rotatebook() { print -r -- "<$*>" }; print rea""dy'
zpty -r -m z out "*ready*"
zpty -w -n z "$1"$'\t\n'
zpty -r -m z out "*<*>*"
print -r -- "<${${out##*<}%%>*}>"
)");
  const auto line = [this](const std::string& words) {
    return shell("HOME=$PWD timeout 60 zsh -f try '" + words + "'").output;
  };
  EXPECT_EQ(line("rotatebook ren"), "<render>\n");
  EXPECT_EQ(line("rotatebook submit --plan l"), "<submit --plan list>\n");
  EXPECT_EQ(line("rotatebook toss my.csv --rates d"), "<toss my.csv --rates deg/s>\n");
  EXPECT_EQ(line("rotatebook page --language g"), "<page --language german>\n");
  EXPECT_EQ(line("rotatebook render my"), "<render my.toml>\n");
}

TEST_F(Manual, ShellsAndManComplainOfNothing) {
  write("rotatebook.1", helpOf({"--man"}));
  for (const char* name : {"bash", "zsh", "fish"}) write(name, helpOf({"--completion", name}));
  EXPECT_NE(shell("bash -n <(echo '(')").status, 0);
  for (const char* name : {"bash", "zsh", "fish"})
    expectAccepted(name + std::string(" -n ./") + name);
  expectAccepted("man --warnings -l rotatebook.1 >/dev/null");
  expectAccepted("mandoc -Tlint -Werror rotatebook.1");
}

TEST_F(Manual, AnotherShellIsRefused) {
  const ChildResult result = run({"help", "--completion", "tcsh"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_EQ(result.error, "rotatebook: --completion must be bash, zsh or fish, not \"tcsh\"\n");
}

}  // namespace
}  // namespace rotatebook::cli::testing
