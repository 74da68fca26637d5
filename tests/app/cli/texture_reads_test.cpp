// How often commands open a scene's texture or mesh: once, so that what they check, simulate, draw
// and record is the same even if the file changes.
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <sys/inotify.h>
#include <unistd.h>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;

/// Counts how often a file is opened from now on, by whatever process.
class OpenCounter {
 public:
  explicit OpenCounter(const fs::path& file) : events_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    // Equal events in a row are merged; closing comes between.
    watching_ = inotify_add_watch(events_, file.c_str(), IN_OPEN | IN_CLOSE) >= 0;
  }
  OpenCounter(const OpenCounter&) = delete;
  OpenCounter& operator=(const OpenCounter&) = delete;
  ~OpenCounter() { close(events_); }

  bool watches() const { return watching_; }

  /// Returns the count since the last call.
  int count() {
    int opens = 0;
    // Events of a file, rather than of a folder's, have no name: all are of one size.
    std::array<inotify_event, 64> events{};
    for (ssize_t size = 0; (size = read(events_, events.data(), sizeof events)) > 0;) {
      const auto number = static_cast<std::size_t>(size) / sizeof(inotify_event);
      for (std::size_t i = 0; i < number; ++i) opens += (events.at(i).mask & IN_OPEN) != 0 ? 1 : 0;
    }
    return opens;
  }

 private:
  int events_;
  bool watching_ = false;
};

class TextureReads : public ProgramTest {
 protected:
  TextureReads() {
    image::writePng(folder() / "cover.png", image::Image(8, 12, image::PixelFormat::Rgb8).view());
    write("covered.toml", "book.front = \"cover.png\"\n" + std::string(kTiny));
  }

  void expectOneOf(const std::vector<std::string>& command, const char* file = "cover.png") const {
    OpenCounter opens(folder() / file);
    ASSERT_TRUE(opens.watches());
    const ChildResult result = run(command);
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_EQ(opens.count(), 1) << command.front();
  }
};

TEST_F(TextureReads, AreOneForEachCommand) {
  expectOneOf({"check", "covered.toml"});
  expectOneOf({"render", "covered.toml", "-o", "."});
  expectOneOf({"render", "covered.toml", "tiny.toml", "-o", "two", "--jobs", "2"});
  expectOneOf({"verify", "covered.mp4"});
  expectOneOf({"verify", "covered.mp4", "--again", "again"});
  expectOneOf({"bench", "covered.toml", "--frames", "2"});
  expectOneOf({"still", "covered.toml", "--time", "0", "-o", "still.png"});
}

TEST_F(TextureReads, AreOneOfAMeshForEachCommand) {
  write("body.obj",
        "v 0 0 0\nv 0.3 0 0\nv 0 0.2 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  write("meshed.toml", std::string(kTiny) + "[body]\nmesh = \"body.obj\"\ndensity = 700\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"info", "meshed.toml"},
        {"check", "meshed.toml"},
        {"simulate", "meshed.toml"},
        {"render", "meshed.toml", "-o", "."},
        {"verify", "meshed.mp4"},
        {"still", "meshed.toml", "--time", "0", "-o", "still.png"}})
    expectOneOf(command, "body.obj");
}

}  // namespace
}  // namespace rotatebook::cli::testing
