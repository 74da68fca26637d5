#include "system/crash_successor.h"

#include <atomic>
#include <csignal>
#include <unistd.h>
#include <utility>

namespace rotatebook::system {
namespace {

/// Arguments as exec takes them: a handler of a crash may not ask for memory.
struct CrashSuccessor {
  std::vector<std::string> words;
  std::vector<char*> pointers{};  // To the words, and a null pointer.
};

std::atomic<CrashSuccessor*> prepared = nullptr;
static_assert(std::atomic<CrashSuccessor*>::is_always_lock_free);

}  // namespace

void setCrashSuccessor(std::vector<std::string> arguments) {
  static CrashSuccessor successor;
  prepared = nullptr;
  successor = {std::move(arguments)};
  successor.words.emplace_back("00");
  for (std::string& word : successor.words) successor.pointers.push_back(word.data());
  successor.pointers.push_back(nullptr);
  prepared = &successor;
}

void becomeCrashSuccessor(int signal) noexcept {
  CrashSuccessor* const successor = prepared;
  if (successor == nullptr) return;
  char* const number = successor->words.back().data();
  number[0] = static_cast<char>('0' + signal / 10 % 10);
  number[1] = static_cast<char>('0' + signal % 10);
  // Signals that a handler or a driver's thread blocks would stay blocked.
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execv("/proc/self/exe", successor->pointers.data());
}

}  // namespace rotatebook::system
