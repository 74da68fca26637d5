// Every command that the documentation shows, as it is written, with small scenes and sizes; those
// within sentences are checked for their options alone.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program_test.h"
#include "house/markdown.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using cli::testing::ProgramTest;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Three seconds, as small as pictures are, and of plain cloth, whose pictures needn't be read.
constexpr const char* kSmall = R"(title = "Small"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
tilt = ["1 deg", "z"]
[clip]
size = [64, 36]
duration = 3
)";

/// A fifth of a second, as there are many of them.
constexpr const char* kShort = R"(title = "Short"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
size = [64, 36]
duration = 0.2
)";

constexpr const char* kPanels = R"(title = "Panels"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
size = [96, 32]
duration = 0.2
[[panel]]
label = "one"
[[panel]]
label = "two"
[[panel]]
label = "three"
)";

constexpr const char* kMap = R"([map]
x = { key = "moments.smallest", from = 0, to = 1 }
y = { key = "moments.middle", from = 0.5, to = 1 }
measure = "growth"
size = [8, 6]
colors = { from = 0, to = 1 }
film = { x = [0, 0.5], duration = 0.1 }
)";

constexpr const char* kStudy = R"([study]
x = { key = "simulation.substeps", values = [1, 2, 4] }
)";

/// Later figures are left out of the folder, which saves half of the time, but for those that the
/// Makefile names; pages show no command with others.
constexpr std::string_view kLastFigure = "scenes/figures/fig06";

/// Writes a scene that isn't small: it is replaced, and one of that name makes room before.
constexpr std::string_view kNew = "rotatebook new ";

/// A line that begins so isn't run here.
struct NotRun {
  std::string_view beginning;
  std::string_view reason;
};

constexpr std::array<NotRun, 9> kNotRun{{
    {"git clone ADDRESS ", "needs the address of the project, and a network"},
    {"apt install ", "needs root; tests/deb.sh runs it on a bare machine"},
    {"tar -xf ", "needs the archive; tests/portable.sh runs it on a bare machine"},
    {"docker ", "needs a daemon; tests/portable.sh takes the steps of the Dockerfile"},
    {"export PATH=", "would find another build; the test sets its own"},
    {"pip install ./python", "is done by tests/python, in an environment of its own"},
    {"rotatebook submit render my.toml -o clips --slurm", "needs a cluster; tests/slurm has one"},
    {"rotatebook status clips", "shows what that command has sent"},
    {"img2webp ", "is no program of this project, nor a package that it installs"},
}};

bool isNotRun(const std::string& line) {
  return std::any_of(kNotRun.begin(), kNotRun.end(),
                     [&](const NotRun& one) { return line.starts_with(one.beginning); });
}

std::string withoutComment(const std::string& line) {
  const std::string command = line.substr(0, line.find(" #"));
  return command.substr(0, command.find_last_not_of(' ') + 1);
}

/// Returns `command` with small pictures; one that measures, with few of them.
std::string madeSmall(const std::string& command) {
  static const std::regex kSize("--size [0-9]+x[0-9]+");
  static const std::regex kFrames(" --frames [0-9]+(?= |$)");
  const std::string result = std::regex_replace(command, kSize, "--size 80x46");
  // Many books need room.
  if (result.find(" --grid ") != std::string::npos)
    return result + " --size 1280x720 --set clip.duration=0.05";
  if (!result.starts_with("rotatebook bench")) return result;
  const std::string size = result == "rotatebook bench" ? " --size 80x46" : "";
  return std::regex_replace(result, kFrames, "") + size + " --frames 4";
}

/// Returns the program's commands among those that `make -n` prints, each on one line.
std::vector<std::string> programsCommands(const std::string& printed) {
  static const std::regex kContinuation(R"(\\\n\s*)");
  static const std::regex kProgram("build/[^/]+/(rotatebook .*)");
  std::vector<std::string> commands;
  for (const std::string& line : linesOf(std::regex_replace(printed, kContinuation, ""))) {
    std::smatch found;
    if (std::regex_match(line, found, kProgram)) commands.push_back(found[1]);
  }
  return commands;
}

/// Returns the options that a command's words have, without their values.
std::vector<std::string> optionsIn(const std::string& command) {
  static const std::regex kOption(R"((?:^| )(--[a-z][a-z0-9-]*|-[a-z])(?![\w-]))");
  std::vector<std::string> options;
  for (std::sregex_iterator it(command.begin(), command.end(), kOption), end; it != end; ++it) {
    options.push_back((*it)[1]);
  }
  return options;
}

class ShownCommands : public ProgramTest {
 protected:
  /// Starts with small scenes in place of those that the project has; of the figures, with the
  /// first.
  ShownCommands() {
    write("my.toml", kSmall);
    write("build/play/live_book.html", "<p>The live book</p>\n");
    const fs::path root = ROTATEBOOK_SOURCE;
    const std::string makefile = readText(root / "Makefile");
    for (const char* below : {"scenes", "docs"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / below)) {
        const std::string name = fs::relative(entry.path(), root).string();
        const bool isLaterFigure = name.starts_with("scenes/figures/") && name > kLastFigure &&
                                   makefile.find(name) == std::string::npos;
        if (name.ends_with(".toml") && !isLaterFigure) write(name, smallSceneFor(name));
        if (name.ends_with(".csv")) write(name, readText(entry.path()));
      }
    }
  }

  /// Returns the problems of the commands and scenes that `page` shows. It may ask for the first
  /// clip.
  std::vector<std::string> problemsOf(const std::string& page) {
    std::vector<std::string> problems;
    if (page.find("out/starter") != std::string::npos && !has("out/starter.mp4")) {
      addProblemsOf("rotatebook render scenes/starter.toml", problems);
    }
    for (const CodeBlock& block : codeBlocksOf(page)) {
      if (block.language == "sh") {
        for (const std::string& line : block.lines) addProblemsOf(withoutComment(line), problems);
      } else if (block.language == "toml") {
        addProblemsOfScene(block, problems);
      }
    }
    static const std::regex kCommand("    (rotatebook|make) .*");
    for (const std::string& line : proseOf(page)) {
      if (std::regex_match(line, kCommand)) problems.push_back(line + "\nis in no block of sh");
    }
    for (const std::string& span : codeSpansOf(page)) addProblemsOfSpan(span, problems);
    return problems;
  }

 private:
  static std::string smallSceneFor(const std::string& name) {
    if (name == "scenes/starter.toml") return kSmall;
    if (name.starts_with("scenes/comparisons/") || name.starts_with("docs/")) return kPanels;
    if (name.starts_with("scenes/maps/")) return std::string(kShort) + kMap;
    return name.starts_with("scenes/studies/") ? std::string(kShort) + kStudy : kShort;
  }

  int runInShell(const std::string& command) const {
    const std::string path = fs::path(ROTATEBOOK_PROGRAM).parent_path().string();
    return std::system(("cd '" + folder().string() + "' && PATH='" + path + "':\"$PATH\" && { " +
                        command + "; } >log.txt 2>&1")
                           .c_str());
  }

  /// All files but those that hold no result: what commands print, and the lists of what was made.
  std::map<std::string, std::string> results() const {
    std::map<std::string, std::string> found;
    for (const std::string& name : files()) {
      const bool isResult = !name.ends_with('/') && name != "log.txt" &&
                            !name.ends_with("/frames.manifest") && !name.ends_with(".xxh128");
      if (isResult) found[name] = read(name);
    }
    return found;
  }

  void addProblemsOf(const std::string& line, std::vector<std::string>& problems) {
    if (line.empty() || isNotRun(line)) return;
    if (line.starts_with("make ")) {
      addProblemsOfMake(line, problems);
    } else if (line.starts_with("rotatebook ")) {
      addProblemsOfCommand(madeSmall(line), problems);
    } else if (!line.starts_with("cp ")) {
      problems.push_back(line + "\nis neither a command of rotatebook nor listed as not run");
    } else if (runInShell(line) != 0) {
      problems.push_back(line + '\n' + read("log.txt"));
    }
  }

  /// Runs a command, which must succeed and destroy nothing.
  void addProblemsOfCommand(const std::string& command, std::vector<std::string>& problems) {
    const bool isNew = command.starts_with(kNew);
    if (isNew) fs::remove(folder() / command.substr(kNew.size()));
    const auto before = results();
    if (runInShell(command) != 0) problems.push_back(command + '\n' + read("log.txt"));
    const auto after = results();
    if (isNew) write(command.substr(kNew.size()), kSmall);
    for (const auto& [name, bytes] : before) {
      const auto now = after.find(name);
      if (now == after.end()) problems.push_back(command + "\nremoves " + name);
      if (now != after.end() && now->second != bytes) {
        problems.push_back(command + "\nchanges " + name);
      }
    }
  }

  /// Lets make say what it would do; what it would render is rendered, once for all pages.
  void addProblemsOfMake(const std::string& line, std::vector<std::string>& problems) {
    const std::string dryRun =
        "env -u MAKEFLAGS -u MAKEOVERRIDES make --no-print-directory -n -C '" +
        std::string(ROTATEBOOK_SOURCE) + "' " + line.substr(5);
    if (runInShell(dryRun) != 0) {
      problems.push_back(line + '\n' + read("log.txt"));
      return;
    }
    for (const std::string& command : programsCommands(read("log.txt"))) {
      if (made_.insert(command).second) addProblemsOfCommand(madeSmall(command), problems);
    }
  }

  /// Returns the help of a command; "" if there is no such command. `command` may be COMMAND.
  const std::string& helpOf(const std::string& command) {
    const auto [known, isNew] = helps_.try_emplace(command);
    if (!isNew) return known->second;
    const std::string words = command == "COMMAND" ? "" : command + ' ';
    runInShell("rotatebook " + words + "--help");
    const std::string help = read("log.txt");
    if (help.find("Usage: rotatebook " + words) != std::string::npos) known->second = help;
    return known->second;
  }

  /// Checks command and options of a text between backticks: "rotatebook render my.toml", or
  /// "render --resume".
  void addProblemsOfSpan(const std::string& span, std::vector<std::string>& problems) {
    static const std::regex kCommand("(rotatebook )?([a-z]+|COMMAND)( .*)?");
    std::smatch found;
    if (!std::regex_match(span, found, kCommand) || span == "rotatebook") return;
    const std::vector<std::string> options = optionsIn(found[3]);
    if (!found[1].matched && options.empty()) return;
    const std::string& help = helpOf(found[2]);
    if (help.empty() && found[1].matched) problems.push_back(span + "\nis no command");
    if (help.empty()) return;
    for (const std::string& option : options) {
      const std::regex isListed("[ ,]" + option + "(?![\\w-])");
      if (!std::regex_search(help, isListed)) problems.push_back(span + "\nhas no " + option);
    }
  }

  /// Has a scene checked; what lacks the motion's start is given one.
  void addProblemsOfScene(const CodeBlock& block, std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& line : block.lines) text += line + '\n';
    const bool isRecorded = text.find("\"recorded\"") != std::string::npos;
    if (!isRecorded && text.find("[initial]") == std::string::npos) {
      text += "[initial]\nangular_velocity = [5.0, 0.0, 0.0]\ntilt = [0.01, \"z\"]\n";
    }
    write("block.toml", text);
    if (runInShell("rotatebook check block.toml") != 0) problems.push_back(text + read("log.txt"));
    fs::remove(folder() / "block.toml");
  }

  std::map<std::string, std::string> helps_;  ///< By command.
  inline static std::set<std::string> made_;  ///< The program's commands that make has run.
};

class Documentation : public ShownCommands, public ::testing::WithParamInterface<std::string> {};

TEST_P(Documentation, ShowsCommandsThatWorkAndDestroyNothing) {
  EXPECT_THAT(problemsOf(readText(fs::path(ROTATEBOOK_SOURCE) / GetParam())), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Pages, Documentation, ::testing::ValuesIn(documentationPages()),
                         [](const auto& page) {
                           std::string name = page.param.substr(0, page.param.rfind('.'));
                           std::erase_if(name, [](unsigned char c) { return !std::isalnum(c); });
                           return name;
                         });

class WrongDocumentation : public ShownCommands {
 protected:
  /// Expects that one problem of a page is found.
  void expectProblem(const std::string& page, const std::string& problem) {
    SCOPED_TRACE(page);
    const std::vector<std::string> problems = problemsOf(page);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems[0], HasSubstr(problem));
  }
};

TEST_F(WrongDocumentation, IsNoticed) {
  expectProblem("```sh\nrotatebook render scenes/starter.toml --no-such-option\n```\n",
                "--no-such-option");
  expectProblem("```sh\nrotatebook render scenes/no-such-scene.toml\n```\n", "no-such-scene.toml");
  expectProblem("```sh\nrotatebook bench --frame 60\n```\n", "--frame");
  expectProblem("```sh\nmake no-such-target\n```\n", "no-such-target");
  expectProblem("```sh\nmake render SCENE=scenes/starter.toml ARGS=\"--no-pgn\"\n```\n",
                "--no-pgn");
  expectProblem("```sh\nrotatebok doctor\n```\n", "neither a command of rotatebook");
  expectProblem("    rotatebook doctor\n", "is in no block of sh");
  expectProblem("```toml\n[clip]\nsizes = [32, 18]\n```\n", "did you mean \"size\"?");
  expectProblem(
      "```sh\nrotatebook simulate scenes/starter.toml --csv out/starter.csv --set "
      "body.mass=2\n```\n",
      "changes out/starter.csv");
  expectProblem("```sh\nmake gallery PROGRAM='build/x/rotatebook no-such-command'\n```\n",
                "no-such-command");
  EXPECT_THAT(problemsOf("```sh\nrotatebook check my.toml    # fine\n```\n"), IsEmpty());
}

// As the README has them; pages that show `make figures` needn't make all of it again.
TEST_F(ShownCommands, AreThoseThatMakeRuns) {
  EXPECT_THAT(problemsOf("```sh\nmake render\n"
                         "rotatebook render scenes/comparisons/models.toml --no-png\n"
                         "rotatebook map scenes/maps/map-delay.toml\nmake figures\n```\n"),
              IsEmpty());
  for (const char* name : {"out/axes.mp4", "out/figb-flip-interval-study.csv", "out/fig01-axes.png",
                           "out/bound-in-maps.png", "out/index.html"}) {
    EXPECT_TRUE(has(name)) << name;
  }
}

TEST_F(WrongDocumentation, IsNoticedWithinSentences) {
  expectProblem("Compare with `rotatebook dif A B --max 8`.\n", "is no command");
  expectProblem("Compare with `rotatebook diff A B --maximum 8`.\n", "has no --maximum");
  expectProblem("`render --resum`\n", "has no --resum");
  expectProblem("`rotatebook\nrender -x`\n", "has no -x");
  EXPECT_THAT(
      problemsOf("`rotatebook diff A B --max 8 -o C`, `render --resume`, `cmake --preset a`,"
                 "`rotatebook COMMAND --help`, `rotatebook`, `render`, `rotatebook::Error`"),
      IsEmpty());
}

}  // namespace
}  // namespace rotatebook::house
