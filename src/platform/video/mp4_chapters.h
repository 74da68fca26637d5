// Chapters in an MP4. Inside the room only.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/frame_rate.h"
#include "video/video_settings.h"

namespace rotatebook::video {

/// The most chapters that a box of them counts.
inline constexpr std::size_t kMostChapters = 255;

/// Returns the content of the box "chpl", Nero's list of chapters, which players know. libavformat
/// writes a second track with it, while a clip is one track alone.
std::string chapterList(const std::vector<Chapter>& chapters, FrameRate rate);

/// Puts the box at the end of "moov/udta" of a complete MP4 whose index is in front, as libavformat
/// writes it, and moves the pictures; does nothing without chapters. Throws MachineError.
void addChapters(const std::filesystem::path& mp4, const std::vector<Chapter>& chapters,
                 FrameRate rate);

}  // namespace rotatebook::video
