#include "page/pack.h"

#include <system_error>

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/error.h"
#include "image/png_file.h"
#include "image/webp_writer.h"
#include "page/pack_archive.h"
#include "page/pack_folder.h"
#include "page/page.h"
#include "system/build_id.h"
#include "system/file_checksum.h"
#include "video/clip_reader.h"
#include "video/recoder.h"
#include "video/video_writer.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

constexpr float kPictureQuality = 82;
/// x264's preset: slower ones gain 7 % in three times the time.
constexpr double kKeyFrameInterval = 5;  // Saves 6 % of what 2 s take. [s]
constexpr int kThreads = 4;              // The bytes depend on it, so it isn't the machine's.

void copyInto(system::AtomicFile& file, const fs::path& from) {
  std::error_code error;
  fs::copy_file(from, file.temporaryPath(), fs::copy_options::overwrite_existing, error);
  if (!error) return;
  throw MachineError(fmt::format("can't copy {} to {}: {}", from.string(),
                                 file.finalPath().string(), error.message()),
                     system::kindOfError(error.value()));
}

void recodeInto(system::AtomicFile& file, const Figure& figure, const fs::path& from, int crf) {
  const video::ClipMetadata metadata = video::readClipMetadata(from);
  const video::PictureSize size = video::readPictureSize(from);
  video::VideoSettings settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.frameRate = figure.frameRate;
  settings.crf = crf;
  settings.preset = video::kWebPreset;
  settings.threads = kThreads;
  settings.keyFrameInterval = kKeyFrameInterval;
  settings.title = metadata.title;
  settings.comment = metadata.comment;
  settings.chapters = figure.chapters;
  video::recode(from, file.temporaryPath(), settings);
}

void packClip(const Figure& figure, const Pack& pack, PackFolder& folder,
              const PackProgress& progress) {
  const fs::path from = pack.results / figure.clip;
  // Of WebMs, which may be transparent, no other coding would play everywhere.
  if (from.extension() != ".mp4") {
    return folder.write(figure.clip, "", [&](auto& file) { copyInto(file, from); });
  }
  const std::string source =
      checksumOf(fmt::format("{}\n{}\n{}\n{}", system::checksumOfFile(from), pack.crf,
                             system::buildId(), video::ffmpegVersion()));
  if (folder.has(figure.clip, source)) return;
  if (progress) progress(figure.clip);
  folder.write(figure.clip, source, [&](auto& file) { recodeInto(file, figure, from, pack.crf); });
}

bool isArchive(const Pack& pack) {
  return pack.target.extension() == ".zip";
}

/// Returns the folder that is filled: the target, or one beside the archive, as there may not be
/// room elsewhere.
fs::path folderOf(const Pack& pack) {
  return isArchive(pack) ? fs::path(pack.target).replace_extension(".rotatebook-pack")
                         : pack.target;
}

std::vector<std::string> namesOf(const std::vector<Figure>& figures) {
  std::vector<std::string> names{kPageName};
  for (const Figure& figure : figures) {
    names.insert(names.end(), figure.files.begin(), figure.files.end());
    for (const std::string& picture : figure.pictures)
      names.push_back(FigureFiles{.isPacked = true}.nameOfPicture(picture));
    if (!figure.clip.empty()) names.push_back(figure.clip);
  }
  return names;
}

void packFigure(const Figure& figure, const Pack& pack, PackFolder& folder,
                const PackProgress& progress) {
  for (const std::string& name : figure.files) {
    folder.write(name, "", [&](auto& file) { copyInto(file, pack.results / name); });
  }
  for (const std::string& picture : figure.pictures) {
    const image::Image pixels = image::readPng(pack.results / picture);
    folder.write(FigureFiles{.isPacked = true}.nameOfPicture(picture),
                 image::webpText(pixels.view(), kPictureQuality));
  }
  if (!figure.clip.empty()) packClip(figure, pack, folder, progress);
}

}  // namespace

std::vector<fs::path> filesOfPack(const std::vector<Figure>& figures, const Pack& pack) {
  const fs::path folder = folderOf(pack);
  std::vector<fs::path> files{folder / kPackMark};
  for (const std::string& name : namesOf(figures)) files.push_back(folder / name);
  if (isArchive(pack)) files.push_back(pack.target);
  return files;
}

void requirePackable(const std::vector<Figure>& figures, const Pack& pack) {
  std::error_code missing;
  if (fs::equivalent(pack.target, pack.results, missing)) {
    throw InputError(fmt::format(
        "--pack {} is the folder with the results, whose clips would be replaced; name another",
        pack.target.string()));
  }
  if (!isArchive(pack)) return PackFolder::requireUsable(pack.target, namesOf(figures));
  requirePackArchive(pack.target);
  try {
    PackFolder::requireUsable(folderOf(pack), namesOf(figures));
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}, as {} is put together in that one", error.what(), pack.target.string()));
  }
}

void writePack(const std::vector<Figure>& figures, const std::string& html, const Pack& pack,
               const PackProgress& progress) {
  requirePackable(figures, pack);
  const std::vector<std::string> names = namesOf(figures);
  PackFolder folder(folderOf(pack), names);
  for (const Figure& figure : figures) packFigure(figure, pack, folder, progress);
  folder.write(kPageName, html);
  folder.finish();
  if (!isArchive(pack)) return;
  writeZip(folder.folder(), names, pack.target);
  folder.remove();
}

}  // namespace rotatebook::page
