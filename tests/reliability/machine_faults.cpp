// Another machine than this one: its locks, its start and the numbers of its processes.
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "reliability/faults.h"

extern "C" {

int flock(int file, int operation) {
  const char* locks = std::getenv("ROTATEBOOK_FAULT_LOCKS");
  if (locks == nullptr) return rotatebook::faults::next<int(int, int)>("flock")(file, operation);
  if (std::string_view(locks) == "unseen") return 0;
  errno = ENOLCK;
  return -1;
}

pid_t getpid() {
  const char* process = std::getenv("ROTATEBOOK_FAULT_PROCESS");
  if (process == nullptr) return rotatebook::faults::next<pid_t()>("getpid")();
  return static_cast<pid_t>(std::strtol(process, nullptr, 10));
}

}  // extern "C"

namespace rotatebook::faults {

void meet(const char* path) {
  const char* folder = std::getenv("ROTATEBOOK_FAULT_MEETING");
  static bool met = false;
  if (folder == nullptr || met || std::strstr(path, "/.frames.manifest.rotatebook-") == nullptr)
    return;
  met = true;
  // Whoever makes the first folder waits for the other to make the second
  const std::string first = std::string(folder) + "/first",
                    second = std::string(folder) + "/second";
  if (next<int(const char*, mode_t)>("mkdir")(first.c_str(), 0777) != 0) {
    next<int(const char*, mode_t)>("mkdir")(second.c_str(), 0777);
  }
  constexpr int kMaxTries = 10'000;
  for (int tries = 0; tries < kMaxTries && access(second.c_str(), F_OK) != 0; ++tries) usleep(2000);
}

const char* redirected(const char* path) {
  const char* start = std::getenv("ROTATEBOOK_FAULT_START");
  if (start == nullptr || std::string_view(path) != "/proc/sys/kernel/random/boot_id") return path;
  return start;
}

}  // namespace rotatebook::faults
