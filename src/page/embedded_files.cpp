#include "page/embedded_files.h"

// The symbols come from cmake/embed.cmake.
#define ROTATEBOOK_EMBEDDED_TEXT(function, symbol)                                        \
  extern "C" const char embedded_page_##symbol##_begin[], embedded_page_##symbol##_end[]; \
  std::string_view rotatebook::page::function() {                                         \
    return {embedded_page_##symbol##_begin, embedded_page_##symbol##_end};                \
  }

ROTATEBOOK_EMBEDDED_TEXT(indexTemplate, index_html)
ROTATEBOOK_EMBEDDED_TEXT(clipTemplate, clip_html)
ROTATEBOOK_EMBEDDED_TEXT(studyTemplate, study_html)
ROTATEBOOK_EMBEDDED_TEXT(stillTemplate, still_html)
ROTATEBOOK_EMBEDDED_TEXT(libraryStyle, uPlot_min_css)
ROTATEBOOK_EMBEDDED_TEXT(pageStyle, page_css)
ROTATEBOOK_EMBEDDED_TEXT(libraryScript, uPlot_iife_min_js)
ROTATEBOOK_EMBEDDED_TEXT(playerScript, player_js)
ROTATEBOOK_EMBEDDED_TEXT(plotsScript, plots_js)
ROTATEBOOK_EMBEDDED_TEXT(pageScript, page_js)
