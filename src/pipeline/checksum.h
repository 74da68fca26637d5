// Checksums that show whether a file is as it was written.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace rotatebook::pipeline {

/// XXH3 of 128 bits of what is added part by part, as checksumOf() has it of the whole.
class Checksum {
 public:
  Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;
  ~Checksum();

  void add(std::string_view bytes);
  /// Of all so far.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// XXH3 of 128 bits as 32 hexadecimal digits, as xxh128sum prints it. It finds damage, not forgery.
std::string checksumOf(std::string_view bytes);

/// That of a file's content. Throws MachineError if it can't be read, isn't there or isn't a file.
std::string checksumOfFile(const std::filesystem::path& path);

}  // namespace rotatebook::pipeline
