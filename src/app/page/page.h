// The page of all figures in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "page/figure.h"

namespace rotatebook::page {

/// The page's name in its folder.
inline constexpr const char* kPageName = "index.html";

/// Returns the page: the first of `figures`, large; what there is to see; an overview; then the
/// other figures, in their order. It needs no other files than the pictures and clips beside it.
std::string pageText(const std::string& title, const std::vector<Figure>& figures);

/// Returns whether `html` is a page that pageText() made, of whatever figures.
bool isPage(std::string_view html);

}  // namespace rotatebook::page
