// The figure of a study: its plot, and from its result what was expected and measured.
#include <string_view>
#include <vector>

#include "embedded/page.h"
#include "page/expectation_table.h"
#include "page/figure.h"
#include "page/result_json.h"
#include "store/fingerprint.h"
#include "store/study_files.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

}  // namespace

Figure studyFigure(const scene::Scene& scene, const fs::path& folder, const Language& say) {
  const store::StudyFiles files = store::studyFiles(folder, scene.name);
  for (const auto& file : {files.csv, files.json}) requireFile(file, scene, "study");
  for (const auto& file : files.plots) requireFile(file, scene, "study");
  const std::vector<Check> checks = readChecks(files.json, scene, store::studySceneChecksum(scene),
                                               "study", "run the study again", say);

  Figure figure{FigureKind::Study, scene.name, say(scene.title)};
  figure.badge = unmetBadge(checks, say);
  Html links;
  const auto link = [&](const fs::path& file, const std::string& title) {
    figure.files.push_back(file.filename().string());
    links += linkItem(figure.files.back(), title);
  };
  for (const fs::path& plot : files.plots) {
    link(plot, formatOf(plot));
    if (plot.extension() == ".svg") figure.thumbnail = figure.files.back();
  }
  link(files.csv, "CSV");
  figure.section =
      filled(studyTemplate(),
             {{"id", escaped(scene.name)},
              {"anchor", addressOf(scene.name)},
              {"title", escaped(figure.title)},
              {"badge", figure.badge},
              {"plot", addressOf(figure.thumbnail)},
              {"caption", captionOf(scene, say)},
              {"toy", toyButton(scene, say)},
              {"checks",
               foldedChecks(checks, checksTable(say("Expected and measured"), checks, say), say)},
              {"links", links},
              {"scene", sceneDetails(scene, say)}},
             say);
  return figure;
}

}  // namespace rotatebook::page
