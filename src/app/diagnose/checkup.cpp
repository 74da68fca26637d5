#include "diagnose/checkup.h"

#include <cstddef>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "overlay/text.h"
#include "system/atomic_file.h"
#include "system/machine.h"

namespace rotatebook::diagnose {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLowSpace = 500'000'000;  // PNGs of a clip take 100 to 700 MB. [bytes]

/// Returns `folder`, or the nearest of its parents that exists.
fs::path existingPart(const fs::path& folder) {
  std::error_code ignored;
  fs::path part = fs::absolute(folder, ignored).lexically_normal();
  while (!fs::exists(part, ignored) && part.has_parent_path() && part != part.parent_path()) {
    part = part.parent_path();
  }
  return part;
}

/// Returns why no file can be made in `folder`, or empty. Makes one and removes it, since
/// permissions don't show every obstacle.
std::string writeFailure(const fs::path& folder) {
  try {
    system::AtomicFile(folder / "rotatebook-doctor").write("x");
    return "";
  } catch (const MachineError& error) {
    return error.what();
  }
}

FolderCheck checkFolder(const fs::path& folder) {
  FolderCheck check{.path = folder};
  const fs::path part = existingPart(folder);
  std::error_code error;
  check.freeBytes = fs::space(part, error).available;
  if (error) {
    check.freeBytes = 0;
    check.failure = fmt::format("{}: {}", part.string(), error.message());
  } else if (!fs::is_directory(part, error)) {
    check.failure = part.string() + " is not a folder";
  } else {
    check.failure = writeFailure(part);
  }
  return check;
}

std::string checkFont() {
  try {
    overlay::Typesetter().measure("rotatebook", {}, 1000);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

void addEncoderProblems(Checkup& checkup) {
  std::string names;  // Of the formats that share a failure, as where FFmpeg can't be loaded.
  for (std::size_t i = 0; i < checkup.encoders.size(); ++i) {
    const video::EncoderCheck& check = checkup.encoders[i];
    if (check.failure.empty()) continue;
    names = joined({names, std::string(nameOf(check.format))});
    if (i + 1 < checkup.encoders.size() && checkup.encoders[i + 1].failure == check.failure) {
      continue;
    }
    const std::string instead =
        check.found.empty() ? "" : fmt::format("; {} encodes in its place", check.found);
    checkup.problems.push_back(
        {fmt::format("{}: {}{}", names, check.failure, instead), check.remedy});
    names.clear();
  }
}

void addOtherProblems(Checkup& checkup) {
  if (!checkup.fontFailure.empty()) {
    checkup.problems.push_back(
        {checkup.fontFailure, "mount /proc: the font is read through /proc/self/fd"});
  }
  const FolderCheck& folder = checkup.folder;
  if (!folder.failure.empty()) {
    checkup.problems.push_back({folder.failure, "name a folder that you may write, with -o DIR"});
  } else if (folder.freeBytes < kLowSpace) {
    const double megabytes = static_cast<double>(folder.freeBytes) / 1e6;
    checkup.problems.push_back(
        {fmt::format("{} has {} MB left, and a clip's PNGs may take more", folder.path.string(),
                     roundedText(megabytes, 3)),
         "free some space, render with --no-png, or name another folder, -o DIR"});
  }
}

}  // namespace

bool Checkup::ready() const {
  const bool encodes = !encoders.empty() && !encoders.front().found.empty();
  return graphics.draws() && encodes && fontFailure.empty() && folder.failure.empty();
}

Checkup checkUp(const fs::path& folder) {
  Checkup checkup;
  checkup.graphics = checkGraphics();
  checkup.problems = diagnose(checkup.graphics, readGraphicsFacts());
  for (const video::VideoFormat format : video::kVideoFormats) {
    checkup.encoders.push_back(video::checkEncoder(format));
  }
  checkup.fontFailure = checkFont();
  checkup.folder = checkFolder(folder);
  checkup.cores = system::coreCount();
  checkup.memory = system::memorySize();
  addEncoderProblems(checkup);
  addOtherProblems(checkup);
  return checkup;
}

std::optional<Problem> explainCrash(const render::DeviceChoice& choice) {
  return diagnoseCrash(checkGraphics(), readGraphicsFacts(), choice);
}

}  // namespace rotatebook::diagnose
