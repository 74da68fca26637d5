// Checksums that show whether bytes are as they were written.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace rotatebook {

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

}  // namespace rotatebook
