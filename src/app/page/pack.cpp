#include "page/pack.h"

#include <algorithm>
#include <memory>
#include <zip.h>

#include "base/error.h"
#include "image/png_file.h"
#include "image/webp_writer.h"
#include "system/atomic_file.h"
#include "video/clip_reader.h"
#include "video/recoder.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

constexpr float kPictureQuality = 82;
/// x264's preset: slower ones gain 7 % in three times the time.
constexpr const char* kPreset = "slow";
constexpr double kKeyFrameInterval = 5;  // Saves 6 % of what 2 s take. [s]
constexpr int kThreads = 4;              // The bytes depend on it, so it isn't the machine's.

void copyFile(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error) {
    throw MachineError("can't copy " + from.string() + " to " + to.string() + ": " +
                       error.message());
  }
}

void packClip(const Figure& figure, const fs::path& from, const fs::path& to, int crf) {
  // Of WebMs, which may be transparent, no other coding would play everywhere.
  if (from.extension() != ".mp4") {
    copyFile(from, to);
    return;
  }
  const video::ClipMetadata metadata = video::readClipMetadata(from);
  const video::PictureSize size = video::readPictureSize(from);
  video::VideoSettings settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.frameRate = figure.frameRate;
  settings.crf = crf;
  settings.preset = kPreset;
  settings.threads = kThreads;
  settings.keyFrameInterval = kKeyFrameInterval;
  settings.title = metadata.title;
  settings.comment = metadata.comment;
  system::AtomicFile file(to);
  video::recode(from, file.temporaryPath(), settings);
  file.commit();
}

using Archive = std::unique_ptr<zip_t, decltype([](zip_t* archive) { zip_discard(archive); })>;

[[noreturn]] void failZip(const fs::path& file, const char* cause) {
  throw MachineError("can't write " + file.string() + ": " + cause);
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

void addToZip(zip_t* archive, const fs::path& from, const fs::path& zip) {
  zip_source_t* source = zip_source_file(archive, from.c_str(), 0, -1);
  if (source == nullptr) failZip(zip, zip_strerror(archive));
  const zip_int64_t index =
      zip_file_add(archive, from.filename().c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    failZip(zip, zip_strerror(archive));
  }
  const auto entry = static_cast<zip_uint64_t>(index);
  // 1980-01-01 00:00, the first day of a ZIP's clock.
  if (zip_set_file_compression(archive, entry, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_dostime(archive, entry, 0, (1 << 5) | 1, 0) != 0) {
    failZip(zip, zip_strerror(archive));
  }
}

}  // namespace

void packFiles(const std::vector<Figure>& figures, const fs::path& folder, const fs::path& target,
               int crf, const PackProgress& progress) {
  for (const Figure& figure : figures) {
    for (const std::string& file : figure.files) copyFile(folder / file, target / file);
    for (const std::string& picture : figure.pictures) {
      const image::Image pixels = image::readPng(folder / picture);
      system::writeFileAtomically(target / FigureFiles{.isPacked = true}.nameOfPicture(picture),
                                  image::webpText(pixels.view(), kPictureQuality));
    }
    if (figure.clip.empty()) continue;
    if (progress) progress(figure.clip);
    packClip(figure, folder / figure.clip, target / figure.clip, crf);
  }
}

void writeZip(const fs::path& folder, const fs::path& file) {
  system::AtomicFile whole(file);
  int code = 0;
  Archive archive(zip_open(whole.temporaryPath().c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
  if (archive == nullptr) failZip(file, "libzip can't begin it");
  for (const fs::path& one : filesIn(folder)) addToZip(archive.get(), one, file);
  if (zip_close(archive.get()) != 0) failZip(file, zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // zip_close() has freed it.
  whole.commit();
}

}  // namespace rotatebook::page
