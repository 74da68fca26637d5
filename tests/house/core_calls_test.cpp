// The core reaches no file, thread, clock or stream, by whichever header their names come in.
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "house/source_tree.h"

namespace rotatebook::house {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Of std::filesystem the core has the path and its members alone, which are words.
const char* const kFiles =
    R"(\bfilesystem\b(?!::path\b|>)|\bfs::(?!path\b)|)"
    // The same functions, found by the type of their argument.
    R"((^|[^\w.>:])((weakly_)?canonical|copy_(file|symlink)|create_(director|hard_link|symlink)\w*|)"
    R"(current_path|equivalent|exists|file_size|hard_link_count|is_(directory|regular_file|symlink)|)"
    R"(last_write_time|permissions|read_symlink|remove(_all)?|rename|resize_file|(symlink_)?status|)"
    R"(temp_directory_path)\s*\()";

const char* const kStreams =
    R"(std::w?((i|o)?(f|string)stream|(file|string|stream)buf|i?ostream|istream|cin|cout|cerr|clog)\b|)"
    R"(\b(v?(f|s|sn)?printf|f?puts|f?open|popen)\s*\()";

const char* const kThreads =
    R"(std::(\w*mutex|j?thread|this_thread|async|condition_variable\w*|\w+_lock|lock_guard|call_once|)"
    R"(once_flag|(shared_)?future|promise|packaged_task|latch|barrier|\w+_semaphore|stop_\w+|execution)\b|)"
    R"(\bpthread_\w+|\b(fork|system|getenv)\s*\()";

const char* const kClocksAndChance =
    R"(\bchrono\b|\bclock\s*\(\s*\)|(^|[^\w.>:])time\s*\(\s*(0\s*\)|NULL|nullptr|&)|)"
    R"((^|[^\w:]|std)::(clock|time)\s*\(|)"
    R"(\b(clock_gettime|gettimeofday|timespec_get|localtime\w*|gmtime\w*|nanosleep|usleep)\s*\(|)"
    R"(std::(random_device|mt19937\w*|\w+_(engine|distribution))\b|\bs?rand\s*\()";

const std::regex& notInTheCore() {
  static const std::regex kAll(std::string(kFiles) + "|" + kStreams + "|" + kThreads + "|" +
                               kClocksAndChance + R"(|using\s+namespace\s+std\b)");
  return kAll;
}

std::vector<std::string> forbiddenIn(std::istream& text) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_search(line.substr(0, line.find("//")), notInTheCore())) lines.push_back(line);
  }
  return lines;
}

void expectForbidden(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    std::istringstream text(line);
    EXPECT_THAT(forbiddenIn(text), ElementsAre(line));
  }
}

TEST(CoreCalls, TellThoseThatReachFiles) {
  expectForbidden({"if (fs::exists(path)) return;", "std::filesystem::remove(path);",
                   "getenv(\"HOME\")", "fopen(name, \"r\")",
                   "for (auto& e : fs::directory_iterator(folder))", "fs::permissions(path, mode)",
                   "std::filesystem::hard_link_count(path)", "std::filesystem::perms mode;",
                   "namespace files = std::filesystem;", "using namespace std;",
                   "using std::filesystem::status;", "return exists(scene.folder);",
                   "n = hard_link_count(path);", "rename(path, other);"});
}

TEST(CoreCalls, TellStreams) {
  expectForbidden({"std::ofstream file(name);", "std::ifstream(name) >> x;", "std::fstream f;",
                   "std::wofstream f;", "std::filebuf buffer;", "std::ostringstream text;",
                   "std::stringstream text;", "std::cout << x;", "std::cerr << x;",
                   "void print(std::ostream& to)", "std::snprintf(text, 8, format)",
                   "printf(\"%g\", x)", "open (name, O_RDONLY)"});
}

TEST(CoreCalls, TellThreads) {
  expectForbidden(
      {"std::mutex lock;", "std::recursive_mutex lock;", "std::shared_mutex lock;",
       "std::thread worker(run);", "std::jthread worker(run);", "std::this_thread::yield();",
       "std::async(run)", "std::condition_variable ready;", "std::condition_variable_any ready;",
       "std::lock_guard held(lock);", "std::scoped_lock held(lock);", "std::call_once(flag, run)",
       "std::future<int> sum;", "std::sort(std::execution::par, begin, end)",
       "pthread_create(&id, nullptr, run, nullptr)", "system(\"ls\")"});
}

TEST(CoreCalls, TellClocksAndChance) {
  expectForbidden({"std::chrono::system_clock::now()", "chrono::steady_clock::time_point begin;",
                   "using std::chrono::seconds;", "clock()", "std::clock()", "time(nullptr)",
                   "std::time(&now)", "::time(now)", "clock_gettime(CLOCK_REALTIME, &now)",
                   "std::mt19937_64 random;", "std::normal_distribution<double> error;",
                   "std::random_device seed;", "rand()", "srand(7)"});
}

TEST(CoreCalls, TellWhatIsRight) {
  for (const std::string line :
       {"fs::path folder;", "// fs::exists(path)", "path.stem()", "reopen (x)",
        "std::filesystem::path(\"a\") / name", "#include <filesystem>", "start_ = time();",
        "sample.time (0)", "double time(int frame)", "int threads = 1;", "\"one clock, one mutex\"",
        "std::remove(begin, end, x)", "keys.exists(name)", "strand(x)", "std::atomic<bool> stop;",
        "scene.panels(0).rename(name)", "hyperbolicTime(x)"}) {
    std::istringstream text(line);
    EXPECT_THAT(forbiddenIn(text), IsEmpty()) << line;
  }
}

TEST(CoreCalls, AreNoneThatTheCoreMustNotMake) {
  std::size_t seen = 0;
  for (const fs::path& file : filesBelow(kSource / "core")) {
    std::ifstream text(file);
    EXPECT_THAT(forbiddenIn(text), IsEmpty()) << file;
    ++seen;
  }
  EXPECT_GT(seen, 110U);  // measured 126
}

}  // namespace
}  // namespace rotatebook::house
