#include "page/page.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/version.h"
#include "embedded/page.h"
#include "page/story.h"

namespace rotatebook::page {
namespace {

constexpr std::string_view kOverview = R"(<nav class="overview" aria-labelledby="page/overview">
<h2 id="page/overview">{{"Overview"}}</h2>
{{groups}}</nav>
)";

constexpr std::string_view kGroup = R"(<h3>{{heading}}</h3>
{{items}})";

constexpr std::string_view kSheet = R"(<ul class="sheet">
{{items}}</ul>
)";

/// Opened by a link to a figure in it, too, by a search and by printing.
constexpr std::string_view kFoldedContent =
    R"(<details class="folded"><summary>{{"{count} more"}}</summary>
{{content}}</details>
)";

constexpr std::string_view kItem = R"(<li><a href="#{{anchor}}">
<span class="frame"><img src="{{thumbnail}}" alt="" loading="lazy" decoding="async"></span>
<span class="title">{{title}}</span>
</a>{{badge}}</li>
)";

constexpr std::string_view kContents = R"~(<nav class="contents" aria-label="{{"Contents"}}">
<button type="button" class="previous" aria-label="{{"Previous figure"}}" title="{{"Previous figure (←)"}}" hidden></button>
<details><summary>{{"Contents"}}</summary>
<ol>
{{chapters}}</ol></details>
<button type="button" class="next" aria-label="{{"Next figure"}}" title="{{"Next figure (→)"}}" hidden></button>
</nav>
)~";

constexpr std::string_view kContentsChapter =
    R"(<li><a class="of-chapter" href="#{{place}}">{{title}}</a><ol>
{{items}}</ol></li>
)";

constexpr std::string_view kContentsItem = R"(<li><a href="#{{anchor}}">{{title}}</a></li>
)";

/// A part of the page that isn't a chapter.
constexpr std::string_view kContentsPart =
    R"(<li><a class="of-chapter" href="#page/{{part}}">{{title}}</a></li>
)";

constexpr std::string_view kChapter = R"(<section class="chapter" aria-labelledby="{{place}}">
<header class="opening"><h2 id="{{place}}">{{title}}</h2>{{words}}</header>
{{figures}}</section>
)";

constexpr std::string_view kWords = R"(<p class="{{class}}">{{text}}</p>
)";

Html wordsOf(const char* kind, const std::string& text) {
  if (text.empty()) return {};
  return filled(kWords, {{"class", {kind}}, {"text", escaped(text)}});
}

/// The anchor of a chapter. Those of the page itself have a slash, as no scene's name has.
Html placeOf(const ToldChapter& chapter) {
  return escaped("chapter/" + chapter.id);
}

Html itemOf(const Figure& figure) {
  return filled(kItem, {{"anchor", addressOf(figure.id)},
                        {"thumbnail", addressOf(figure.thumbnail)},
                        {"title", escaped(figure.title)},
                        {"badge", figure.badge}});
}

/// Returns what is folded away of a chapter; empty if nothing is.
Html foldedAway(const ToldChapter& chapter, const Html& content, const Language& say) {
  const auto count = std::ranges::count_if(chapter.figures, &ToldFigure::isFolded);
  if (count == 0) return {};
  return filled(kFoldedContent, {{"count", {std::to_string(count)}}, {"content", content}}, say);
}

Html overviewOf(const std::vector<ToldChapter>& chapters, const Language& say) {
  Html groups;
  for (const ToldChapter& chapter : chapters) {
    Html shown, folded;
    for (const ToldFigure& told : chapter.figures)
      (told.isFolded ? folded : shown) += itemOf(*told.figure);
    Html items = filled(kSheet, {{"items", shown}});
    items += foldedAway(chapter, filled(kSheet, {{"items", folded}}), say);
    groups += filled(kGroup, {{"heading", escaped(chapter.title)}, {"items", items}});
  }
  return filled(kOverview, {{"groups", groups}}, say);
}

Html contentsOf(const std::vector<ToldChapter>& chapters, const Figure& lead, bool hasLive,
                const Language& say) {
  const auto part = [](const char* name, const std::string& title) {
    return filled(kContentsPart, {{"part", {name}}, {"title", escaped(title)}});
  };
  Html all = hasLive ? part("live", say("The live book")) : Html{};
  all += part("overview", say("Overview"));
  for (const ToldChapter& chapter : chapters) {
    Html items;
    for (const ToldFigure& told : chapter.figures) {
      items += filled(kContentsItem, {{"anchor", addressOf(told.figure->id)},
                                      {"title", escaped(told.figure->title)}});
    }
    // A chapter of the lead alone has no place of its own.
    const bool isLead = chapter.figures.size() == 1 && chapter.figures.front().figure == &lead;
    all += filled(kContentsChapter, {{"place", isLead ? addressOf(lead.id) : placeOf(chapter)},
                                     {"title", escaped(chapter.title)},
                                     {"items", items}});
  }
  return filled(kContents, {{"chapters", all}}, say);
}

/// Returns the chapters' figures but for the `lead`, which stands above them.
Html chaptersOf(const std::vector<ToldChapter>& chapters, const Figure& lead, const Language& say) {
  Html all;
  for (const ToldChapter& chapter : chapters) {
    Html figures, folded;
    for (const ToldFigure& told : chapter.figures) {
      if (told.figure == &lead) continue;
      Html& part = told.isFolded ? folded : figures;
      part += wordsOf("between", told.words);
      part += told.figure->section;
    }
    figures += foldedAway(chapter, folded, say);
    if (figures.text.empty()) continue;
    all += filled(kChapter, {{"place", placeOf(chapter)},
                             {"title", escaped(chapter.title)},
                             {"words", wordsOf("of-chapter", chapter.words)},
                             {"figures", figures}});
  }
  return all;
}

/// Returns the picture that other sites show for the page.
Html previewOf(const Figure& figure) {
  return filled("<meta property=\"og:image\" content=\"{{file}}\">\n",
                {{"file", addressOf(figure.thumbnail)}});
}

/// Parts made of the figures; empty without any.
struct Parts {
  Html preview{}, contents{}, lead{}, overview{}, chapters{};
};

Parts partsOf(const std::vector<Figure>& figures, bool hasLive, const Language& say) {
  if (figures.empty()) return {};
  const Figure& lead = figures.front();
  const std::vector<ToldChapter> chapters = tell(figures, story(), say);
  Parts parts{.preview = previewOf(lead), .lead = lead.section};
  if (figures.size() == 1) return parts;
  parts.contents = contentsOf(chapters, lead, hasLive, say);
  parts.overview = overviewOf(chapters, say);
  parts.chapters = chaptersOf(chapters, lead, say);
  return parts;
}

Html asIs(std::string_view text) {
  return {std::string(text)};
}

/// Returns the words that scripts say, as JSON for assets/page/words.js; nothing in English.
Html wordsOfScripts(const Language& say) {
  if (say.ofScripts.empty()) return {};
  std::vector<std::string> rows;
  for (const auto& [english, text] : say.ofScripts)
    rows.push_back(quotedText(english) + ":" + quotedText(text));
  std::string json = "{" + joined(rows) + "}";
  for (std::size_t at = json.find('<'); at != json.npos; at = json.find('<', at))
    json.replace(at, 1, "\\u003C");
  return filled(
      "<script type=\"application/json\" class=\"words\" lang=\"{{tag}}\">{{json}}</script>\n",
      {{"tag", escaped(say.tag)}, {"json", {json}}});
}

}  // namespace

std::string pageText(const std::string& title, const std::vector<Figure>& figures,
                     const std::string& live, const Language& say) {
  const Parts parts = partsOf(figures, !live.empty(), say);
  const Html fragment =
      live.empty()
          ? Html{}
          : filled("<div class=\"live\" id=\"page/live\">{{live}}</div>\n", {{"live", {live}}});
  return filled(indexTemplate(),
                {{"title", escaped(say(title))},
                 {"language", escaped(say.tag)},
                 {"words", wordsOfScripts(say)},
                 {"version", escaped(kVersion)},
                 {"preview", parts.preview},
                 {"library-style", asIs(libraryStyle())},
                 {"style", asIs(pageStyle())},
                 {"contents", parts.contents},
                 {"live", fragment},
                 {"lead", parts.lead},
                 {"overview", parts.overview},
                 {"figures", parts.chapters},
                 {"library", asIs(libraryScript())},
                 {"words-script", asIs(wordsScript())},
                 {"player", asIs(playerScript())},
                 {"plots", asIs(plotsScript())},
                 {"contents-script", asIs(contentsScript())},
                 {"script", asIs(pageScript())}},
                say)
      .text;
}

bool isPage(std::string_view html) {
  return html.find(R"(<meta name="generator" content="rotatebook )") != std::string_view::npos;
}

}  // namespace rotatebook::page
