#include "pipeline/checksum.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <new>
#include <xxhash.h>

namespace rotatebook::pipeline {
namespace {

struct StateDeleter {
  void operator()(XXH3_state_t* state) const noexcept { XXH3_freeState(state); }
};

std::string hexadecimal(const XXH128_hash_t& hash) {
  std::array<char, 33> digits;
  std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits.data();
}

}  // namespace

std::string checksumOf(std::string_view bytes) {
  return hexadecimal(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string checksumOfFile(const std::filesystem::path& path) {
  const std::unique_ptr<XXH3_state_t, StateDeleter> state(XXH3_createState());
  if (state == nullptr) throw std::bad_alloc();
  XXH3_128bits_reset(state.get());
  std::ifstream stream(path, std::ios::binary);
  std::array<char, 65'536> block;
  do {
    stream.read(block.data(), block.size());
    XXH3_128bits_update(state.get(), block.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  return hexadecimal(XXH3_128bits_digest(state.get()));
}

}  // namespace rotatebook::pipeline
