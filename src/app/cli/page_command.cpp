#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/ostream.h>

#include "base/clip_limits.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/option_checks.h"
#include "cli/scene_options.h"
#include "image/png_file.h"
#include "page/language.h"
#include "page/pack.h"
#include "page/page.h"
#include "picture/thumbnail.h"
#include "store/clip_files.h"
#include "store/result_owners.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

struct PageArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::string folder = "out";
  std::string title = page::kTitle;
  std::string language = "english";
  bool noThumbnails = false;
  std::string live;
  std::string pack;
  int packCrf = page::kPackCrf;
};

constexpr std::uintmax_t kLongestFragment = 64 << 20;  // [bytes]

constexpr const char* kOtherFolder = "name another folder with -o";

/// Returns the paths without repeats of a file; the first is kept.
std::vector<std::string> withoutRepeats(const std::vector<std::string>& paths) {
  std::set<fs::path> seen;
  std::vector<std::string> once;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::path file = fs::weakly_canonical(path, error);
    if (seen.insert(error ? fs::path(path) : file).second) once.push_back(path);
  }
  return once;
}

ReadScenes readShown(const PageArguments& arguments) {
  ReadScenes shown = readAllScenes(withoutRepeats(arguments.scenes), [&](const std::string& path) {
    return arguments.sceneOptions.read(path);
  });
  refuseSameNames(shown.scenes);
  if (!arguments.live.empty())
    shown.inputs.push_back({arguments.live, "the live book that --live names"});
  return shown;
}

image::Image drawThumbnail(const scene::Scene& scene, const picture::DeviceChoice& device) {
  try {
    return picture::drawThumbnail(scene, device);
  } catch (const MachineError& error) {
    throw MachineError(
        std::string(error.what()) +
            "\n  --no-thumbnails makes the page without drawing: its overview shows the "
            "posters then",
        error.kind());
  }
}

/// Returns whether the overview shows a picture of the figure; studies and maps have their own.
bool needsThumbnail(const page::Figure& figure) {
  return figure.kind != page::FigureKind::Study && figure.kind != page::FigureKind::Map;
}

void drawThumbnails(const ReadScenes& shown, const PageArguments& arguments,
                    std::vector<page::Figure>& figures) {
  const auto fileOf = [&](std::size_t i) {
    return store::clipFiles(arguments.folder, shown.scenes[i].name).thumbnail;
  };
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!needsThumbnail(figures[i])) continue;
    refuseInputs(fileOf(i), shown.inputs, kOtherFolder);
    const std::string remedy = fmt::format(
        "the page's picture of {} would replace it; rename the scene, or make the page without it "
        "by --no-thumbnails",
        shown.scenes[i].name);
    store::refuseResultsOfOthers({store::ResultKind::Clip, shown.scenes[i].name}, {fileOf(i)},
                                 remedy);
    store::refusePictureOfOthers(fileOf(i), remedy);
  }
  const picture::DeviceChoice device = arguments.deviceOptions.choice();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!needsThumbnail(figures[i])) continue;
    const scene::Scene& scene = shown.scenes[i];
    const image::Image picture = drawThumbnail(scene, device);
    image::writePng(fileOf(i), picture.view(), scene::isTransparent(scene));
  }
}

/// Returns the live book's fragment of HTML; empty if none is named. Throws InputError.
std::string liveOf(const PageArguments& arguments) {
  return arguments.live.empty() ? "" : system::readInput(arguments.live, kLongestFragment);
}

std::vector<page::Figure> readFigures(const ReadScenes& shown, const PageArguments& arguments,
                                      const page::Language& language, bool isPacked) {
  std::vector<page::Figure> figures;
  for (const scene::Scene& scene : shown.scenes) {
    figures.push_back(page::readFigure(
        scene, arguments.folder, {.hasThumbnails = !arguments.noThumbnails, .isPacked = isPacked},
        language));
  }
  return figures;
}

std::uintmax_t sizeOf(const fs::path& path) {
  if (!fs::is_directory(path)) return fs::file_size(path);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  return bytes;
}

/// The page for the web that --pack asks for.
struct PackToWrite {
  page::Pack pack;
  std::vector<page::Figure> figures;
};

/// Returns it once nothing is in its way; nothing without --pack.
std::optional<PackToWrite> packOf(const ReadScenes& shown, const PageArguments& arguments,
                                  const page::Language& language) {
  if (arguments.pack.empty()) return std::nullopt;
  PackToWrite all{{arguments.folder, arguments.pack, arguments.packCrf},
                  readFigures(shown, arguments, language, true)};
  store::Footprint footprint;
  for (const fs::path& file : filesOfPack(all.figures, all.pack)) footprint.addFile(file);
  refuseInputs(footprint, shown.inputs, "name another folder with --pack");
  requirePackable(all.figures, all.pack);
  return all;
}

void writePack(const PackToWrite& all, const std::string& html) {
  page::writePack(all.figures, html, all.pack, [](const std::string& file) {
    fmt::print(std::cerr, "packing {}\n", oneLine(file));
  });
  fmt::print(std::cout, "wrote {}, {} MB for the web\n", oneLine(all.pack.target.string()),
             roundedText(static_cast<double>(sizeOf(all.pack.target)) / 1e6, 3));
}

/// Throws InputError if there is a page that isn't of this program.
void refuseOtherPage(const fs::path& path) {
  if (!fs::is_regular_file(path) || page::isPage(system::readFileOrEmpty(path))) return;
  throw InputError(path.string() +
                   " is no page of rotatebook, and would be replaced; move it away, or name "
                   "another folder with -o");
}

int writePage(const PageArguments& arguments) {
  const page::Language language = page::readLanguage(arguments.language);
  const auto textOf = [&](const std::vector<page::Figure>& figures) {
    return page::pageText(arguments.title, figures, liveOf(arguments), language);
  };
  const ReadScenes shown = readShown(arguments);
  const auto path = fs::path(arguments.folder) / page::kPageName;
  refuseInputs(path, shown.inputs, kOtherFolder);
  refuseOtherPage(path);
  std::vector<page::Figure> figures = readFigures(shown, arguments, language, false);
  const std::optional<PackToWrite> pack = packOf(shown, arguments, language);
  if (!arguments.noThumbnails) drawThumbnails(shown, arguments, figures);
  system::writeFileAtomically(path, textOf(figures));
  for (const page::Figure& figure : figures) {
    for (const std::string& note : figure.leftOut)
      fmt::print(std::cerr, "note: {}\n", oneLine(note));
  }
  fmt::print(std::cout, "wrote {}, {}\n", oneLine(path.string()),
             countText(std::ssize(figures), "figure"));
  if (pack) writePack(*pack, textOf(pack->figures));
  return kDone;
}

}  // namespace

void addPageCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "page",
                 "Show what was rendered on one page, with players, plots and tables", writePage);
  command
      .add_option("SCENE", arguments.scenes,
                  "Scene files, in the order of the page; the first is shown large, at its top")
      ->required()
      ->check(notStandardInput);
  addOption(command, "-o,--output", "DIR", arguments.folder,
            "Folder with the results of render and study; the page goes there, too")
      ->capture_default_str();
  addOption(command, "--title", "TEXT", arguments.title, "The page's heading")
      ->capture_default_str();
  addOption(command, "--language", "english|german|FILE", arguments.language,
            "english, german, or the file of a list of words such as assets/words/german.toml")
      ->capture_default_str();
  addOption(command, "--live", "FILE", arguments.live,
            "The live book: a fragment of HTML that is put at the page's top as it is");
  addOption(command, "--pack", "DIR|FILE.zip", arguments.pack,
            "Write the page again for the web, to this folder or .zip: its clips are coded "
            "anew, smaller, and keep their records");
  command
      .add_option(
          "--pack-crf", arguments.packCrf,
          "Rate factor of packed clips: at 22, clips are three times as large as at 33, and "
          "verify still proves their pictures")
      ->check(wholeNumber(kBestCrf, kWorstCrf))
      ->capture_default_str()
      ->needs("--pack");
  command.add_flag("--no-thumbnails", arguments.noThumbnails,
                   "Draw nothing, and show the posters themselves in the overview");
  arguments.sceneOptions.addTo(command);
  arguments.deviceOptions.addTo(command);
  command.footer(R"(
Writes DIR/index.html, which any browser shows without a network or a server. It shows the files that
render and study left in DIR; give --set and --size as they were given to these. For the overview, the
posters are drawn again, small and without text, as DIR/NAME.thumbnail.png. A scene named twice is shown
once.

Example:
  rotatebook render scenes/figures/*.toml
  rotatebook page scenes/figures/*.toml)");
}

}  // namespace rotatebook::cli
