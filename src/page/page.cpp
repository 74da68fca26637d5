#include "page/page.h"

#include <array>

#include "base/version.h"
#include "page/embedded_files.h"

namespace rotatebook::page {
namespace {

struct Group {
  FigureKind kind;
  const char* heading;
};

constexpr std::array<Group, 4> kGroups{{{FigureKind::Still, "Stills"},
                                        {FigureKind::Clip, "Clips"},
                                        {FigureKind::Comparison, "Comparisons"},
                                        {FigureKind::Study, "Studies"}}};

constexpr std::string_view kGroup = R"(<h3>{{heading}}</h3>
<ul class="sheet">
{{items}}</ul>
)";

constexpr std::string_view kItem = R"(<li><a href="#{{id}}">
<span class="frame"><img src="{{picture}}" alt="" loading="lazy" decoding="async"></span>
<span class="name">{{id}}</span>
<span class="title">{{title}}</span>
</a>{{badge}}</li>
)";

Html itemOf(const Figure& figure) {
  return filled(kItem, {{"id", escaped(figure.id)},
                        {"picture", addressOf(figure.thumbnail)},
                        {"title", escaped(figure.title)},
                        {"badge", figure.badge}});
}

Html overviewOf(const std::vector<Figure>& figures) {
  Html overview;
  for (const Group& group : kGroups) {
    Html items;
    for (const Figure& figure : figures) {
      if (figure.kind == group.kind) items += itemOf(figure);
    }
    if (items.text.empty()) continue;
    overview += filled(kGroup, {{"heading", escaped(group.heading)}, {"items", items}});
  }
  return overview;
}

Html asIs(std::string_view text) {
  return {std::string(text)};
}

}  // namespace

std::string pageText(const std::string& title, const std::vector<Figure>& figures) {
  Html sections;
  for (const Figure& figure : figures) sections += figure.section;
  return filled(indexTemplate(), {{"title", escaped(title)},
                                  {"version", escaped(kVersion)},
                                  {"library-style", asIs(libraryStyle())},
                                  {"style", asIs(pageStyle())},
                                  {"overview", overviewOf(figures)},
                                  {"figures", sections},
                                  {"library", asIs(libraryScript())},
                                  {"player", asIs(playerScript())},
                                  {"plots", asIs(plotsScript())},
                                  {"script", asIs(pageScript())}})
      .text;
}

}  // namespace rotatebook::page
