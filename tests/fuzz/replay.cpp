// A target without a fuzzer: runs each file of the folders it is given once. So every seed and
// every finding of the past is a test, with any compiler.
#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sys/resource.h>
#include <vector>

#include "fuzz/fuzzing.h"
#include "system/read_file.h"

namespace {

namespace fs = std::filesystem;

// Of one input, in processor time. Measured 0.1 to 1.9 of the slowest, whose many pages of memory
// cost more the busier the machine is. [s]
constexpr double kLongest = 4;
constexpr long kMaxMemory = 512 * 1024;  // Of all. [KiB]

double processorTime() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool hidden = entry.path().filename().string().starts_with('.');
    if (entry.is_regular_file() && !hidden) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Returns the problem with the way an input was taken; "" if there is none.
std::string problemWith(const fs::path& file) {
  const std::string bytes = rotatebook::system::readFileOrEmpty(file);
  const double start = processorTime();
  try {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  } catch (const std::exception& error) {
    return std::string("throws what isn't for users: ") + error.what();
  }
  const double time = processorTime() - start;
  return time <= kLongest ? "" : "takes " + std::to_string(time) + " s";
}

long mostMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

int main(int argc, char** argv) {
  int count = 0, failures = 0;
  for (int i = 1; i < argc; ++i) {
    for (const fs::path& file : filesBelow(argv[i])) {
      ++count;
      // Printed first: what ends the program can't tell which file it was.
      std::cout << file.string() << std::endl;
      const std::string problem = problemWith(file);
      if (!problem.empty()) std::cout << "  FAILED: " << problem << '\n';
      failures += problem.empty() ? 0 : 1;
    }
  }
  const bool frugal = mostMemory() <= kMaxMemory;
  if (!frugal) std::cout << "FAILED: took " << mostMemory() / 1024 << " MiB\n";
  std::cout << count << " files, " << failures << " failures\n";
  return count > 0 && failures == 0 && frugal ? 0 : 1;
}
