// The README's commands, as they are written.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "base/read_file.h"
#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;

/// Three seconds, as small as pictures are.
constexpr const char* kSmall = R"(title = "Small"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
size = [32, 18]
duration = 3
)";

/// Those of the section "Commands", in their order, without the comments.
std::vector<std::string> commands() {
  const std::string readme = readFileOrEmpty(fs::path(ROTATEBOOK_SOURCE) / "README.md");
  const std::size_t begin = readme.find("\n## Commands\n");
  std::istringstream section(readme.substr(begin, readme.find("\n## ", begin + 1) - begin));
  std::vector<std::string> found;
  for (std::string line; std::getline(section, line);) {
    if (line.starts_with("    rotatebook ")) found.push_back(line.substr(4, line.find("  #") - 4));
  }
  return found;
}

class Readme : public ProgramTest {
 protected:
  Readme() {
    fs::create_directories(folder() / "scenes/figures");
    for (const char* name : {"my.toml", "scenes/starter.toml", "scenes/figures/one.toml"}) {
      write(name, kSmall);
    }
  }

  int runInShell(const std::string& command) const {
    const std::string path = fs::path(ROTATEBOOK_PROGRAM).parent_path().string();
    return std::system(("cd '" + folder().string() + "' && PATH='" + path + "':\"$PATH\" && { " +
                        command + "; } >log.txt 2>&1")
                           .c_str());
  }

  /// All files but those that hold no result: what commands print, and the list of what was made.
  std::map<std::string, std::string> results() const {
    std::map<std::string, std::string> found;
    for (const std::string& name : files()) {
      const bool isResult =
          !name.ends_with('/') && name != "log.txt" && !name.ends_with("/frames.manifest");
      if (isResult) found[name] = read(name);
    }
    return found;
  }
};

TEST_F(Readme, HasCommandsThatWorkAndDestroyNothing) {
  const std::vector<std::string> all = commands();
  ASSERT_GE(all.size(), 15U);
  for (const std::string& command : all) {
    SCOPED_TRACE(command);
    const auto before = results();
    EXPECT_EQ(runInShell(command), 0) << read("log.txt");
    const auto after = results();
    for (const auto& [name, bytes] : before) {
      const auto now = after.find(name);
      ASSERT_NE(now, after.end()) << name << " is gone";
      EXPECT_TRUE(now->second == bytes) << name << " is another";
    }
  }
}

}  // namespace
}  // namespace rotatebook::cli::testing
