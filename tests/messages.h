// Messages, compared whole with those of messages.txt, which is beside the tests of a room.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::messages {

/// The messages of a room's tests: of each test those that it looks at, in their order. Where
/// ROTATEBOOK_UPDATE_GOLDENS is set, those of the tests that run are written anew.
class Messages {
 public:
  static Messages& ofRoom() {
    static Messages messages(ROTATEBOOK_TEST_DATA "/messages.txt");
    return messages;
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  ~Messages() {
    if (!isUpdating_ || test_.empty()) return;
    std::ofstream file(path_);
    file << kHead;
    for (const auto& [test, messages] : all_) {
      file << '\n' << test << '\n';
      for (const std::string& message : messages) file << kBullet << indented(message) << '\n';
    }
  }

  /// Returns whether `text` is the running test's next message, but for where the build is and
  /// line ends at its end.
  ::testing::AssertionResult isNext(const std::string& text) {
    const std::string actual = comparable(text);
    std::vector<std::string>& messages = messagesOfTest();
    if (isUpdating_) messages.push_back(actual);
    const std::size_t index = next_++;
    if (index < messages.size() && messages[index] == actual) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "The message is\n"
           << actual << "\nand in " << path_ << "\n"
           << (index < messages.size() ? messages[index] : "there is none")
           << "\nROTATEBOOK_UPDATE_GOLDENS=1 writes it anew; read it before you commit it";
  }

 private:
  static constexpr const char* kHead =
      "# The messages that tests look at, test by test; ROTATEBOOK_UPDATE_GOLDENS=1 writes them "
      "anew.\n";
  static constexpr const char* kBullet = "- ";
  static constexpr const char* kIndent = "  ";

  explicit Messages(std::string path) : path_(std::move(path)) {
    std::ifstream file(path_);
    std::string test;
    for (std::string line; std::getline(file, line);) {
      if (line.empty() || line.starts_with('#')) continue;
      if (line.starts_with(kBullet)) {
        all_[test].push_back(line.substr(2));
      } else if (line.starts_with(kIndent)) {
        all_[test].back() += '\n' + line.substr(2);
      } else {
        test = line;
      }
    }
  }

  std::vector<std::string>& messagesOfTest() {
    const ::testing::TestInfo& info = *::testing::UnitTest::GetInstance()->current_test_info();
    const std::string test = std::string(info.test_suite_name()) + '.' + info.name();
    std::vector<std::string>& messages = all_[test];
    if (test != test_) {
      test_ = test;
      next_ = 0;
      if (isUpdating_) messages.clear();
    }
    return messages;
  }

  static std::string comparable(std::string text) {
    const std::string folder = ROTATEBOOK_TEST_OUTPUT "/";
    for (std::size_t at = 0; (at = text.find(folder, at)) != std::string::npos;)
      text.erase(at, folder.size());
    while (text.ends_with('\n')) text.pop_back();
    return text;
  }

  static std::string indented(std::string text) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3)
      text.insert(at + 1, kIndent);
    return text;
  }

  std::string path_;
  const bool isUpdating_ = std::getenv("ROTATEBOOK_UPDATE_GOLDENS") != nullptr;
  std::map<std::string, std::vector<std::string>> all_;
  std::string test_;
  std::size_t next_ = 0;
};

inline ::testing::AssertionResult isNextMessage(const char*, const std::string& actual) {
  return Messages::ofRoom().isNext(actual);
}

}  // namespace rotatebook::messages

/// Expects that a message is, word by word, the running test's next one of messages.txt.
#define EXPECT_MESSAGE(message) EXPECT_PRED_FORMAT1(rotatebook::messages::isNextMessage, message)
