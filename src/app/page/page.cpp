#include "page/page.h"

#include <algorithm>
#include <string_view>

#include "base/version.h"
#include "embedded/page.h"

namespace rotatebook::page {
namespace {

constexpr std::string_view kOverview = R"(<nav class="overview" aria-labelledby="overview">
<h2 id="overview">Overview</h2>
{{groups}}</nav>
)";

constexpr std::string_view kGroup = R"(<h3>{{heading}}</h3>
<ul class="sheet">
{{items}}</ul>
)";

constexpr std::string_view kItem = R"(<li><a href="#{{id}}">
<span class="frame">{{picture}}</span>
<span class="name">{{id}}</span>
<span class="title">{{title}}</span>
</a>{{badge}}</li>
)";

constexpr std::string_view kPicture =
    R"(<img src="{{file}}" alt="" loading="lazy" decoding="async">)";

/// Figures of some kinds under one heading.
struct Group {
  std::string heading;
  std::vector<FigureKind> kinds;
};

/// Returns the overview's groups. Stills and clips share one, since stills are few.
std::vector<Group> groupsOf(const std::vector<Figure>& figures) {
  const auto has = [&](FigureKind kind) {
    return std::ranges::count(figures, kind, &Figure::kind) > 0;
  };
  const std::string first = !has(FigureKind::Still)  ? "Clips"
                            : !has(FigureKind::Clip) ? "Stills"
                                                     : "Stills and clips";
  return {{first, {FigureKind::Still, FigureKind::Clip}},
          {"Comparisons", {FigureKind::Comparison}},
          {"Studies", {FigureKind::Study}}};
}

Html itemOf(const Figure& figure) {
  const bool drawn = !figure.curves.text.empty();
  return filled(
      kItem, {{"id", escaped(figure.id)},
              {"picture",
               drawn ? figure.curves : filled(kPicture, {{"file", addressOf(figure.thumbnail)}})},
              {"title", escaped(figure.title)},
              {"badge", figure.badge}});
}

/// Returns a link to the overview; empty for a single figure, which has none.
Html linkUp(const std::vector<Figure>& figures) {
  if (figures.size() < 2) return {};
  return {"<p class=\"up\"><a href=\"#overview\">↑ Overview</a></p>\n"};
}

/// Returns the overview; empty for a single figure.
Html overviewOf(const std::vector<Figure>& figures) {
  if (figures.size() < 2) return {};
  Html groups;
  for (const Group& group : groupsOf(figures)) {
    Html items;
    for (const Figure& figure : figures) {
      if (std::ranges::count(group.kinds, figure.kind) > 0) items += itemOf(figure);
    }
    if (items.text.empty()) continue;
    groups += filled(kGroup, {{"heading", escaped(group.heading)}, {"items", items}});
  }
  return filled(kOverview, {{"groups", groups}});
}

Html asIs(std::string_view text) {
  return {std::string(text)};
}

}  // namespace

std::string pageText(const std::string& title, const std::vector<Figure>& figures) {
  Html lead, sections;
  for (const Figure& figure : figures) {
    (&figure == &figures.front() ? lead : sections) += figure.section;
  }
  return filled(indexTemplate(), {{"title", escaped(title)},
                                  {"version", escaped(kVersion)},
                                  {"library-style", asIs(libraryStyle())},
                                  {"style", asIs(pageStyle())},
                                  {"lead", lead},
                                  {"overview", overviewOf(figures)},
                                  {"figures", sections},
                                  {"up", linkUp(figures)},
                                  {"library", asIs(libraryScript())},
                                  {"player", asIs(playerScript())},
                                  {"plots", asIs(plotsScript())},
                                  {"script", asIs(pageScript())}})
      .text;
}

bool isPage(std::string_view html) {
  return html.find(R"(<meta name="generator" content="rotatebook )") != std::string_view::npos;
}

}  // namespace rotatebook::page
