// Checksums, which reveal bytes that have changed since they were written.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace rotatebook {

/// Computes the 128-bit XXH3 checksum of bytes that arrive in pieces; the result equals
/// checksumOf() of the whole.
class Checksum {
 public:
  Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;
  ~Checksum();

  void add(std::string_view bytes);
  /// Returns the checksum of all bytes added so far, as checksumOf() writes it.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the 128-bit XXH3 checksum of `bytes` as 32 hexadecimal digits, as xxh128sum prints it.
/// It detects damage, not forgery.
std::string checksumOf(std::string_view bytes);

}  // namespace rotatebook
