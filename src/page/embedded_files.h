// Templates, style and scripts that are part of the program; from assets/page/. Inside the room
// only.
#pragma once

#include <string_view>

namespace rotatebook::page {

std::string_view indexTemplate();
std::string_view clipTemplate();
std::string_view studyTemplate();
std::string_view stillTemplate();

/// The page's style, the plotting library's before its own.
std::string_view libraryStyle();
std::string_view pageStyle();

/// The page's scripts, in the order in which they are to run.
std::string_view libraryScript();
std::string_view playerScript();
std::string_view plotsScript();
std::string_view pageScript();

}  // namespace rotatebook::page
