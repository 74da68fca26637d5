// Messages, compared whole with those of messages.txt, which is beside the tests of a room.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::messages {

/// The messages of a room's tests: of each test those that it looks at, in their order. Where
/// ROTATEBOOK_UPDATE_GOLDENS is set, those of the tests that run are written anew, and those of
/// tests that their suite has no more are left out; run them in one process then.
class Messages final : public ::testing::EmptyTestEventListener {
 public:
  /// Returns those of this program, which listen to its tests from the first call on.
  static Messages& ofRoom() {
    static Messages* const messages = [] {
      auto made = std::make_unique<Messages>();
      ::testing::UnitTest::GetInstance()->listeners().Append(made.get());
      return made.release();  // The listeners delete it.
    }();
    return *messages;
  }

  Messages() {
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

  /// Returns whether `text` is the running test's next message, but for where the build is and
  /// line ends at its end.
  ::testing::AssertionResult isNext(const std::string& text) {
    const std::string actual = comparable(text);
    std::vector<std::string>& messages = all_[test_];
    if (isUpdating_) messages.push_back(actual);
    const std::size_t index = next_++;
    if (index < messages.size() && messages[index] == actual) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "The message is\n"
           << actual << "\nand in " << path_ << "\n"
           << (index < messages.size() ? messages[index] : "there is none")
           << "\nROTATEBOOK_UPDATE_GOLDENS=1 writes it anew; read it before you commit it";
  }

  void OnTestProgramStart(const ::testing::UnitTest& program) override {
    for (int i = 0; i < program.total_test_suite_count(); ++i) {
      const ::testing::TestSuite& suite = *program.GetTestSuite(i);
      std::set<std::string> known;
      for (int j = 0; j < suite.total_test_count(); ++j)
        known.insert(nameOf(*suite.GetTestInfo(j)));
      std::erase_if(all_, [&](const auto& test) {
        const bool isGone =
            test.first.starts_with(suite.name() + std::string(".")) && !known.contains(test.first);
        if (isGone && !isUpdating_) {
          ADD_FAILURE() << path_ << " has messages of " << test.first
                        << ", which isn't a test any more";
        }
        return isGone;
      });
    }
  }

  void OnTestStart(const ::testing::TestInfo& info) override {
    test_ = nameOf(info);
    next_ = 0;
    if (isUpdating_) all_.erase(test_);
  }

  void OnTestEnd(const ::testing::TestInfo& info) override {
    const auto found = all_.find(test_);
    if (found == all_.end() || found->second.size() <= next_ || !info.result()->Passed()) return;
    ADD_FAILURE() << test_ << " doesn't look at this message of " << path_ << ":\n"
                  << found->second[next_];
  }

  void OnTestProgramEnd(const ::testing::UnitTest& /*program*/) override {
    if (!isUpdating_) return;
    std::ofstream file(path_);
    file << kHead;
    for (const auto& [test, messages] : all_) {
      file << '\n' << test << '\n';
      for (const std::string& message : messages) file << kBullet << indented(message) << '\n';
    }
  }

 private:
  static constexpr const char* kHead =
      "# The messages that tests look at, test by test; ROTATEBOOK_UPDATE_GOLDENS=1 writes them "
      "anew.\n";
  static constexpr const char* kBullet = "- ";
  static constexpr const char* kIndent = "  ";

  static std::string nameOf(const ::testing::TestInfo& info) {
    return std::string(info.test_suite_name()) + '.' + info.name();
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

  const std::string path_ = ROTATEBOOK_TEST_DATA "/messages.txt";
  const bool isUpdating_ = std::getenv("ROTATEBOOK_UPDATE_GOLDENS") != nullptr;
  std::map<std::string, std::vector<std::string>> all_;
  std::string test_;
  std::size_t next_ = 0;
};

/// Has the messages listen even if no test that runs looks at one.
inline const Messages& kListening = Messages::ofRoom();

inline ::testing::AssertionResult isNextMessage(const char*, const std::string& actual) {
  return Messages::ofRoom().isNext(actual);
}

}  // namespace rotatebook::messages

/// Expects that a message is, word by word, the running test's next one of messages.txt.
#define EXPECT_MESSAGE(message) EXPECT_PRED_FORMAT1(rotatebook::messages::isNextMessage, message)
