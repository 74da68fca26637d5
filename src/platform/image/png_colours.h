// The colours of a PNG, as it says itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rotatebook::image {

/// Returns what readPng() takes otherwise than a PNG means it, which reads all as sRGB of 8 bits:
/// sentences without their subject, such as "16 bits a channel, of which 8 are kept". Empty for
/// what is sRGB of 8 bits, or says nothing of it. The bytes must be those of a PNG.
std::vector<std::string> lostColoursOf(std::span<const std::uint8_t> bytes);

}  // namespace rotatebook::image
