// All figures of a folder on one page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/figure.h"

namespace rotatebook::page {

/// The page's name in its folder.
inline constexpr const char* kPageName = "index.html";

/// The page: the first of `figures`, large, what there is to see, an overview, then the others, in
/// their order. It needs no other file
/// than the pictures and clips that lie beside it.
std::string pageText(const std::string& title, const std::vector<Figure>& figures);

}  // namespace rotatebook::page
