#include "interchange/aligned_zip.h"

#include <cstddef>
#include <memory>
#include <zip.h>

#include "base/error.h"

namespace rotatebook::interchange {
namespace {

using Archive = std::unique_ptr<zip_t, decltype([](zip_t* archive) { zip_discard(archive); })>;
using Source = std::unique_ptr<zip_source_t, decltype([](zip_source_t* s) { zip_source_free(s); })>;

[[noreturn]] void fail(const char* cause) {
  throw MachineError(std::string("can't make an archive: ") + cause);
}

/// Adds a file behind `at` bytes of others; returns how many there are then.
std::size_t addTo(zip_t* archive, const NamedBytes& file, std::size_t at) {
  constexpr std::size_t kAlignment = 64, kHead = 30, kFieldHead = 4;
  constexpr zip_uint16_t kPadding = 0x1986;  // What USD's own archives call it.
  zip_source_t* source = zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
  if (source == nullptr) fail(zip_strerror(archive));
  const zip_int64_t index = zip_file_add(archive, file.name.c_str(), source, ZIP_FL_ENC_GUESS);
  if (index < 0) {
    zip_source_free(source);
    fail(zip_strerror(archive));
  }
  const auto entry = static_cast<zip_uint64_t>(index);
  const std::size_t begin = at + kHead + file.name.size() + kFieldHead;
  const std::string padding((kAlignment - begin % kAlignment) % kAlignment, '\0');
  // 1980-01-01 00:00, the first day of a ZIP's clock
  if (zip_set_file_compression(archive, entry, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_dostime(archive, entry, 0, (1 << 5) | 1, 0) != 0 ||
      zip_file_extra_field_set(archive, entry, kPadding, ZIP_EXTRA_FIELD_NEW,
                               reinterpret_cast<const zip_uint8_t*>(padding.data()),
                               static_cast<zip_uint16_t>(padding.size()), ZIP_FL_LOCAL) != 0)
    fail(zip_strerror(archive));
  return begin + padding.size() + file.bytes.size();
}

std::string bytesOf(zip_source_t* source) {
  const auto failed = [&] { fail(zip_error_strerror(zip_source_error(source))); };
  if (zip_source_open(source) != 0) failed();
  std::string bytes, piece(1 << 16, '\0');
  for (;;) {
    const zip_int64_t size = zip_source_read(source, piece.data(), piece.size());
    if (size < 0) failed();
    if (size == 0) break;
    bytes.append(piece, 0, static_cast<std::size_t>(size));
  }
  zip_source_close(source);
  return bytes;
}

}  // namespace

std::string alignedZip(const std::vector<NamedBytes>& files) {
  const Source buffer(zip_source_buffer_create(nullptr, 0, 0, nullptr));
  if (buffer == nullptr) fail("libzip can't begin it");
  Archive archive(zip_open_from_source(buffer.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr));
  if (archive == nullptr) fail("libzip can't begin it");
  zip_source_keep(buffer.get());  // The archive frees it, too.
  std::size_t size = 0;
  for (const NamedBytes& file : files) size = addTo(archive.get(), file, size);
  if (zip_close(archive.get()) != 0) fail(zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // zip_close() has freed it.
  return bytesOf(buffer.get());
}

}  // namespace rotatebook::interchange
