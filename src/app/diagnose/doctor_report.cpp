#include "diagnose/doctor_report.h"

#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/version.h"

namespace rotatebook::diagnose {
namespace {

constexpr int kNameWidth = 21;
constexpr std::size_t kTextWidth = 92;

std::string gigabytes(double bytes) {
  return roundedText(bytes / 1e9, 3) + " GB";
}

void row(const std::string& name, const std::string& text, std::ostream& out) {
  out << "  " << std::left << std::setw(kNameWidth) << name << text << '\n';
}

/// Prints `text` wrapped at kTextWidth, with `first` before the first line and as many spaces
/// before the others. Lines that begin with two spaces are commands, and aren't wrapped.
void printWrapped(const std::string& text, std::string first, std::ostream& out) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string indent(first.size(), ' ');
    std::string done = first;
    first = indent;
    if (line.starts_with("  ")) {
      out << done << line << '\n';
      continue;
    }
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const bool begins = done.size() == indent.size();
      if (!begins && done.size() + 1 + word.size() > kTextWidth) {
        out << done << '\n';
        done = indent + word;
      } else {
        done += (begins ? "" : " ") + word;
      }
    }
    out << done << '\n';
  }
}

std::string kindOf(const DisplayCheck& check) {
  return check.software ? "software" : "hardware";
}

std::string referenceText(const ReferenceCheck& check) {
  if (!check.failure.empty()) return "reference picture failed";
  const image::Comparison& found = check.comparison;
  return fmt::format(
      "reference picture {}: off by at most {} of 255, {} % by more than {} ({} % allowed)",
      found.same ? "right" : "WRONG", found.largest, roundedText(found.differingPercent, 2),
      check.tolerance.largest, roundedText(check.tolerance.failPercent, 3));
}

void printDisplay(const DisplayCheck& check, bool byDefault, std::ostream& out) {
  const render::DisplayCandidate& candidate = check.candidate;
  const std::string cuda = candidate.cudaId ? fmt::format("cuda:{}", *candidate.cudaId) : "";
  const std::string nodes = joined({candidate.drmNode, candidate.renderNode, cuda});
  if (check.failure) {
    row(candidate.name(), check.failure->text(), out);
    if (!nodes.empty()) row("", nodes, out);
    return;
  }
  row(candidate.name(), check.renderer + (byDefault ? "; draws by default" : ""), out);
  row("",
      joined({kindOf(check), check.vendor, "OpenGL " + check.version,
              countText(check.samples, "sample"), nodes}),
      out);
  row("", referenceText(check.reference), out);
}

void printGraphics(const GraphicsCheck& graphics, std::ostream& out) {
  out << "graphics\n";
  if (graphics.library) row("EGL, OpenGL", graphics.library->text(), out);
  if (graphics.devices) row("EGL devices", graphics.devices->text(), out);
  for (std::size_t i = 0; i < graphics.candidates.size(); ++i) {
    printDisplay(graphics.candidates[i], graphics.byDefault == i, out);
  }
}

void printRest(const Checkup& checkup, std::ostream& out) {
  out << "\nencoders\n";
  for (const video::EncoderCheck& check : checkup.encoders) {
    row(std::string(nameOf(check.format)), check.found.empty() ? "none" : check.found, out);
  }
  out << "\nmachine\n";
  row("font", checkup.fontFailure.empty() ? "the one that ships is loaded" : "fails", out);
  const FolderCheck& folder = checkup.folder;
  row("output folder",
      oneLine(folder.path.string()) + ", " +
          (folder.failure.empty() ? gigabytes(static_cast<double>(folder.freeBytes)) + " free"
                                  : "can't be written"),
      out);
  row("cores", std::to_string(checkup.cores), out);
  row("memory", gigabytes(checkup.memory), out);
}

void printProblems(const std::vector<Problem>& problems, std::ostream& out) {
  if (problems.empty()) return;
  out << "\nproblems\n";
  for (std::size_t i = 0; i < problems.size(); ++i) {
    printWrapped(problems[i].what, fmt::format("  {}. ", i + 1), out);
    printWrapped(problems[i].remedy, "     remedy: ", out);
  }
}

/// Lists what a render would lack.
std::string lackText(const Checkup& checkup) {
  const bool encodes = !checkup.encoders.empty() && !checkup.encoders.front().found.empty();
  return joined({checkup.graphics.draws() ? "" : "nothing draws as it should",
                 encodes ? "" : "MP4 can't be encoded",
                 checkup.fontFailure.empty() ? "" : "the font can't be loaded",
                 checkup.folder.failure.empty() ? "" : "the output folder can't be written"});
}

std::string verdict(const Checkup& checkup) {
  if (!checkup.ready()) return "NOT READY to render: " + lackText(checkup) + ".";
  const DisplayCheck& candidate = checkup.graphics.candidates[*checkup.graphics.byDefault];
  const std::size_t count = checkup.problems.size();
  return fmt::format("Ready to render: {} draws ({}), {} encodes{}.", candidate.candidate.name(),
                     kindOf(candidate), checkup.encoders.front().found,
                     count == 0 ? ""
                                : fmt::format("; {} {} reported above", count,
                                              count == 1 ? "problem is" : "problems are"));
}

std::string json(const ReferenceCheck& check) {
  JsonObject object;
  object.addBool("passed", check.passed()).addStringOrNull("error", check.failure);
  if (!check.failure.empty()) return object.text();
  return object.addNumber("largest", check.comparison.largest)
      .addNumber("differing_percent", check.comparison.differingPercent)
      .addNumber("bound_largest", check.tolerance.largest)
      .addNumber("bound_percent", check.tolerance.failPercent)
      .text();
}

std::string json(const std::optional<render::CallFailure>& failure) {
  if (!failure) return "null";
  return JsonObject().addString("call", failure->call).addString("error", failure->error).text();
}

std::string json(const DisplayCheck& check, bool byDefault) {
  const render::DisplayCandidate& candidate = check.candidate;
  const bool isDevice = candidate.kind == render::DisplayCandidate::Kind::Device;
  JsonObject object;
  object.addString("name", candidate.name())
      .addNumberOrNull("device", isDevice ? std::optional<double>(candidate.index) : std::nullopt)
      .addBool("default", byDefault)
      .addStringOrNull("drm_node", candidate.drmNode)
      .addStringOrNull("render_node", candidate.renderNode)
      .addNumberOrNull("cuda", candidate.cudaId)
      .add("failure", json(check.failure));
  if (check.failure) return object.text();
  return object.addString("vendor", check.vendor)
      .addString("renderer", check.renderer)
      .addString("opengl", check.version)
      .addNumber("samples", check.samples)
      .addBool("software", check.software)
      .add("reference_picture", json(check.reference))
      .text();
}

std::string json(const GraphicsCheck& graphics) {
  std::vector<std::string> candidates;
  for (std::size_t i = 0; i < graphics.candidates.size(); ++i) {
    candidates.push_back(json(graphics.candidates[i], graphics.byDefault == i));
  }
  return JsonObject()
      .add("library_failure", json(graphics.library))
      .add("devices_failure", json(graphics.devices))
      .add("displays", jsonArray(candidates))
      .text();
}

std::string json(const video::EncoderCheck& check) {
  return JsonObject()
      .addString("format", nameOf(check.format))
      .addStringOrNull("encoder", check.found)
      .addStringOrNull("error", check.failure)
      .text();
}

std::string json(const FolderCheck& folder) {
  return JsonObject()
      .addString("path", folder.path.string())
      .addInteger("free_bytes", static_cast<std::int64_t>(folder.freeBytes))
      .addStringOrNull("error", folder.failure)
      .text();
}

std::string json(const Problem& problem) {
  return JsonObject().addString("what", problem.what).addString("remedy", problem.remedy).text();
}

}  // namespace

void reportCheckup(const Checkup& checkup, std::ostream& out) {
  out << "rotatebook " << kVersion << "\n\n";
  printGraphics(checkup.graphics, out);
  printRest(checkup, out);
  printProblems(checkup.problems, out);
  out << '\n' << verdict(checkup) << '\n';
}

void reportCheckupAsJson(const Checkup& checkup, std::ostream& out) {
  const auto asJson = [](const auto& part) { return json(part); };
  out << JsonObject()
             .addBool("ready", checkup.ready())
             .addString("version", kVersion)
             .add("graphics", json(checkup.graphics))
             .add("encoders", jsonArrayOf(checkup.encoders, asJson))
             .addStringOrNull("font_error", checkup.fontFailure)
             .add("folder", json(checkup.folder))
             .addNumber("cores", checkup.cores)
             .addInteger("memory_bytes", static_cast<std::int64_t>(checkup.memory))
             .add("problems", jsonArrayOf(checkup.problems, asJson))
             .text()
      << '\n';
}

}  // namespace rotatebook::diagnose
