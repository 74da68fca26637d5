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
/// The heading of a page that is given no other.
inline constexpr const char* kTitle = "The unstable rotation of a book";

/// Returns the page in a language: what there is to see; `live`, a fragment of HTML that is trusted
/// and put in as it is; the first of `figures`, large; an overview; then the other figures, as the
/// story has them. It needs no other files than the pictures and clips beside it.
std::string pageText(const std::string& title, const std::vector<Figure>& figures,
                     const std::string& live = "", const Language& say = {});

/// Returns whether `html` is a page that pageText() made, of whatever figures.
bool isPage(std::string_view html);

}  // namespace rotatebook::page
