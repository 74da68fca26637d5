#include "cli/program_test.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

#include "base/same_bytes.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;

// "Suite.Test", with the slashes of parameterised tests replaced.
std::string folderName() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

}  // namespace

ProgramTest::ProgramTest() : folder_(fs::path(ROTATEBOOK_TEST_OUTPUT) / "cli" / folderName()) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  write("tiny.toml", kTiny);
}

ChildResult ProgramTest::run(const std::vector<std::string>& arguments) const {
  return run(arguments, ChildSettings{});
}

ChildResult ProgramTest::run(const std::vector<std::string>& arguments,
                             ChildSettings settings) const {
  settings.folder = folder_;
  return runChild(ROTATEBOOK_PROGRAM, arguments, settings);
}

ChildResult ProgramTest::runWords(const std::string& words) const {
  ChildSettings settings;
  settings.folder = folder_;
  return runChild("/bin/sh", {"-c", "exec \"$0\" " + words, ROTATEBOOK_PROGRAM}, settings);
}

ChildResult ProgramTest::runWithoutGraphics(const std::vector<std::string>& arguments) const {
  ChildSettings settings;
  settings.environment.emplace_back(kNoGraphics);
  return run(arguments, settings);
}

void ProgramTest::write(const std::string& name, const std::string& content) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream stream(folder_ / name, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) throw std::runtime_error("can't write " + (folder_ / name).string());
}

std::string ProgramTest::read(const std::string& name) const {
  std::ifstream stream(folder_ / name, std::ios::binary);
  if (!stream) throw std::runtime_error("can't read " + (folder_ / name).string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool ProgramTest::has(const std::string& name) const {
  return fs::exists(folder_ / name);
}

std::vector<std::string> ProgramTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string name = fs::relative(entry.path(), folder_).string();
    if (name != "tiny.toml") names.push_back(entry.is_directory() ? name + "/" : name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> ProgramTest::filesBelow(const std::string& folder) const {
  std::vector<std::string> names;
  for (const std::string& name : files()) {
    if (name.starts_with(folder + "/")) names.push_back(name.substr(folder.size() + 1));
  }
  return names;
}

int ProgramTest::expectSameFiles(const std::string& folder, const std::string& other,
                                 const std::string& when) const {
  const std::vector<std::string> names = filesBelow(folder);
  EXPECT_EQ(names, filesBelow(other)) << when;
  int compared = 0;
  for (const std::string& name : names) {
    if (name.empty() || name.ends_with('/')) continue;
    ++compared;
    EXPECT_TRUE(rotatebook::testing::sameBytes(read(other + "/" + name), read(folder + "/" + name)))
        << other << '/' << name << ' ' << when;
  }
  return compared;
}

std::string withoutDistances(const std::string& text) {
  static const std::regex kDistance(
      "  [0-9]+ flips?(, at [^;\n]*)?; energy [^\n]*; [^\n]* the exact motion[^\n]*\n");
  return std::regex_replace(text, kDistance, "");
}

int countOf(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace rotatebook::cli::testing
