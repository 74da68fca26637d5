#include "system/zip_archive.h"

#include <utility>
#include <zip.h>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::system {

void ZipDeleter::operator()(zip* archive) const {
  zip_discard(archive);
}

void ZipDeleter::operator()(zip_file* file) const {
  zip_fclose(file);
}

void ZipDeleter::operator()(zip_source* source) const {
  zip_source_free(source);
}

MemoryZip::MemoryZip(std::string failure)
    : failure_(std::move(failure)), buffer_(zip_source_buffer_create(nullptr, 0, 0, nullptr)) {
  if (buffer_ == nullptr) fail("libzip can't begin it");
  archive_.reset(zip_open_from_source(buffer_.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr));
  if (archive_ == nullptr) fail("libzip can't begin it");
  zip_source_keep(buffer_.get());  // The archive frees it, too.
}

void MemoryZip::addFile(const std::string& path, const std::string& name) {
  add(zip_source_file(archive_.get(), path.c_str(), 0, -1), name);
}

void MemoryZip::addBytes(std::string_view bytes, const std::string& name, std::uint16_t extraId,
                         std::string_view extra) {
  const std::uint64_t entry =
      add(zip_source_buffer(archive_.get(), bytes.data(), bytes.size(), 0), name);
  if (zip_file_extra_field_set(archive_.get(), entry, extraId, ZIP_EXTRA_FIELD_NEW,
                               reinterpret_cast<const zip_uint8_t*>(extra.data()),
                               static_cast<zip_uint16_t>(extra.size()), ZIP_FL_LOCAL) != 0)
    fail(zip_strerror(archive_.get()));
}

void MemoryZip::finish(const std::function<void(std::string_view)>& take) {
  if (zip_close(archive_.get()) != 0) fail(zip_strerror(archive_.get()));
  static_cast<void>(archive_.release());  // zip_close() has freed it.
  zip_source_t* const source = buffer_.get();
  const auto failRead = [&] { fail(zip_error_strerror(zip_source_error(source))); };
  if (zip_source_open(source) != 0) failRead();
  std::string piece(1 << 16, '\0');
  for (;;) {
    const zip_int64_t size = zip_source_read(source, piece.data(), piece.size());
    if (size < 0) failRead();
    if (size == 0) break;
    take(std::string_view(piece).substr(0, static_cast<std::size_t>(size)));
  }
  zip_source_close(source);
}

void MemoryZip::fail(const char* cause) const {
  throw MachineError(fmt::format("{}: {}", failure_, cause));
}

std::uint64_t MemoryZip::add(zip_source* source, const std::string& name) {
  if (source == nullptr) fail(zip_strerror(archive_.get()));
  const zip_int64_t index = zip_file_add(archive_.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    fail(zip_strerror(archive_.get()));
  }
  const auto entry = static_cast<zip_uint64_t>(index);
  // 1980-01-01 00:00, the first day of a ZIP's clock.
  if (zip_set_file_compression(archive_.get(), entry, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_dostime(archive_.get(), entry, 0, (1 << 5) | 1, 0) != 0)
    fail(zip_strerror(archive_.get()));
  return entry;
}

}  // namespace rotatebook::system
