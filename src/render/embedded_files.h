// Shaders and textures that are part of the program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace rotatebook::render {

/// GLSL sources, from shaders/.
std::string_view wholePictureVertexShader();
std::string_view studioFragmentShader();
std::string_view starsFragmentShader();
std::string_view bookVertexShader();
std::string_view coverFragmentShader();
std::string_view paperFragmentShader();
std::string_view toneCurveFragmentShader();

/// The bytes of the PNGs in assets/.
std::span<const std::uint8_t> frontPng();
std::span<const std::uint8_t> spinePng();
std::span<const std::uint8_t> backPng();
std::span<const std::uint8_t> paperPng();
std::span<const std::uint8_t> testFramePng();

}  // namespace rotatebook::render
