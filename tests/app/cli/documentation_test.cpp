// Every command that the documentation shows, as it is written, with small scenes and sizes.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "cli/markdown.h"
#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Three seconds, as small as pictures are.
constexpr const char* kSmall = R"(title = "Small"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
size = [64, 36]
duration = 3
)";

/// A fifth of a second, as there are many of them.
constexpr const char* kShort = R"(title = "Short"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
size = [64, 36]
duration = 0.2
)";

constexpr const char* kPanels = R"(title = "Panels"
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

constexpr const char* kStudy = R"([study]
integrators = ["rk4", "dmv6"]
steps = [1, 2, 4]
)";

/// Later figures are left out of the folder, which saves half of the time; pages show no command
/// with them.
constexpr std::string_view kLastFigure = "scenes/figures/fig06";

/// A line that begins so isn't run here.
struct NotRun {
  std::string_view beginning;
  std::string_view reason;
};

constexpr std::array<NotRun, 3> kNotRun{{
    {"git clone ADDRESS ", "needs the address of the project, and a network"},
    {"export PATH=", "would find another build; the test sets its own"},
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

/// The same command with small pictures; what is measured, of few of them.
std::string madeSmall(const std::string& command) {
  static const std::regex kSize("--size [0-9]+x[0-9]+");
  static const std::regex kFrames(" --frames [0-9]+(?= |$)");
  const std::string result = std::regex_replace(command, kSize, "--size 80x46");
  if (!result.starts_with("rotatebook bench")) return result;
  const std::string size = result == "rotatebook bench" ? " --size 80x46" : "";
  return std::regex_replace(result, kFrames, "") + size + " --frames 4";
}

/// The program's command of `make render ...`, as `make -n` prints it; empty if there is none.
std::string programsCommand(const std::string& printed) {
  static const std::regex kProgram("(?:^|\n)build/[^/\n]+/(rotatebook render [^\n]*)");
  std::smatch found;
  return std::regex_search(printed, found, kProgram) ? found[1].str() : "";
}

class ShownCommands : public ProgramTest {
 protected:
  /// Starts with small scenes in place of those that the project has; of the figures, with the
  /// first.
  ShownCommands() {
    write("my.toml", kSmall);
    const fs::path root = ROTATEBOOK_SOURCE;
    for (const char* below : {"scenes", "docs"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / below)) {
        const std::string name = fs::relative(entry.path(), root).string();
        const bool isLaterFigure = name.starts_with("scenes/figures/") && name > kLastFigure;
        if (name.ends_with(".toml") && !isLaterFigure) write(name, smallSceneFor(name));
      }
    }
  }

  /// What is wrong with the commands and scenes that `page` shows. It may ask for the first clip.
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
    return problems;
  }

 private:
  static std::string smallSceneFor(const std::string& name) {
    if (name == "scenes/starter.toml") return kSmall;
    if (name.starts_with("scenes/comparisons/") || name.starts_with("docs/")) return kPanels;
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
                            !name.ends_with("/frames.manifest") &&
                            !name.ends_with("/frames.xxh128");
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
    const auto before = results();
    if (runInShell(command) != 0) problems.push_back(command + '\n' + read("log.txt"));
    const auto after = results();
    for (const auto& [name, bytes] : before) {
      const auto now = after.find(name);
      if (now == after.end()) problems.push_back(command + "\nremoves " + name);
      if (now != after.end() && now->second != bytes) {
        problems.push_back(command + "\nchanges " + name);
      }
    }
  }

  /// Lets make say what it would do; what it would render is rendered.
  void addProblemsOfMake(const std::string& line, std::vector<std::string>& problems) {
    const std::string dryRun =
        "env -u MAKEFLAGS -u MAKEOVERRIDES make --no-print-directory -n -C '" +
        std::string(ROTATEBOOK_SOURCE) + "' " + line.substr(5);
    if (runInShell(dryRun) != 0) {
      problems.push_back(line + '\n' + read("log.txt"));
      return;
    }
    const std::string command = programsCommand(read("log.txt"));
    if (!command.empty() && line.starts_with("make render ")) {
      addProblemsOfCommand(madeSmall(command), problems);
    }
  }

  /// Has a scene checked; what lacks the motion's start is given one.
  void addProblemsOfScene(const CodeBlock& block, std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& line : block.lines) text += line + '\n';
    if (text.find("[initial]") == std::string::npos) {
      text += "[initial]\nangular_velocity = [5.0, 0.0, 0.0]\n";
    }
    write("block.toml", text);
    if (runInShell("rotatebook check block.toml") != 0) problems.push_back(text + read("log.txt"));
    fs::remove(folder() / "block.toml");
  }
};

class Documentation : public ShownCommands, public ::testing::WithParamInterface<std::string> {};

TEST_P(Documentation, ShowsCommandsThatWorkAndDestroyNothing) {
  EXPECT_THAT(problemsOf(readText(fs::path(ROTATEBOOK_SOURCE) / GetParam())), IsEmpty());
}

std::vector<std::string> pagesWithBlocks() {
  std::vector<std::string> pages;
  for (const std::string& page : documentationPages()) {
    if (!codeBlocksOf(readText(fs::path(ROTATEBOOK_SOURCE) / page)).empty()) pages.push_back(page);
  }
  return pages;
}

INSTANTIATE_TEST_SUITE_P(Pages, Documentation, ::testing::ValuesIn(pagesWithBlocks()),
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
  expectProblem("```sh\nrotatebook still my.toml --time 0 -o out/starter.poster.png\n```\n",
                "changes out/starter.poster.png");
  EXPECT_THAT(problemsOf("```sh\nrotatebook check my.toml    # fine\n```\n"), IsEmpty());
}

}  // namespace
}  // namespace rotatebook::cli::testing
