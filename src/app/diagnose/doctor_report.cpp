#include "diagnose/doctor_report.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/version.h"

namespace rotatebook::diagnose {
namespace {

constexpr int kNameWidth = 21;

std::string gigabytes(double bytes) {
  return roundedText(bytes / 1e9, 3) + " GB";
}

void row(const std::string& name, const std::string& text, std::ostream& out) {
  fmt::print(out, "  {:<{}}{}\n", name, kNameWidth, text);
}

/// Prints `text`, each line after the first with as many spaces before it as `first` has letters.
void printIndented(std::string text, const std::string& first, std::ostream& out) {
  const std::string indent(first.size(), ' ');
  for (auto at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
    text.insert(at + 1, indent);
  fmt::print(out, "{}{}\n", first, text);
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
    printIndented(problems[i].what, fmt::format("  {}. ", i + 1), out);
    printIndented(problems[i].remedy, "     remedy: ", out);
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
  if (!checkup.ready()) return fmt::format("NOT READY to render: {}.", lackText(checkup));
  const DisplayCheck& candidate = checkup.graphics.candidates[*checkup.graphics.byDefault];
  const std::size_t count = checkup.problems.size();
  return fmt::format("Ready to render: {} draws ({}), {} encodes{}.", candidate.candidate.name(),
                     kindOf(candidate), checkup.encoders.front().found,
                     count == 0 ? ""
                                : fmt::format("; {} {} reported above", count,
                                              count == 1 ? "problem is" : "problems are"));
}

Json json(const ReferenceCheck& check) {
  Json object;
  object["passed"] = check.passed();
  object["error"] = orNull(check.failure);
  if (!check.failure.empty()) return object;
  object["largest"] = check.comparison.largest;
  object["differing_percent"] = check.comparison.differingPercent;
  object["bound_largest"] = check.tolerance.largest;
  object["bound_percent"] = check.tolerance.failPercent;
  return object;
}

Json json(const std::optional<render::CallFailure>& failure) {
  if (!failure) return nullptr;
  return {{"call", failure->call}, {"error", failure->error}};
}

Json json(const DisplayCheck& check, bool byDefault) {
  const render::DisplayCandidate& candidate = check.candidate;
  const bool isDevice = candidate.kind == render::DisplayCandidate::Kind::Device;
  Json object;
  object["name"] = candidate.name();
  object["device"] = isDevice ? Json(candidate.index) : Json();
  object["default"] = byDefault;
  object["drm_node"] = orNull(candidate.drmNode);
  object["render_node"] = orNull(candidate.renderNode);
  object["cuda"] = orNull(candidate.cudaId);
  object["failure"] = json(check.failure);
  if (check.failure) return object;
  object["vendor"] = check.vendor;
  object["renderer"] = check.renderer;
  object["opengl"] = check.version;
  object["samples"] = check.samples;
  object["software"] = check.software;
  object["reference_picture"] = json(check.reference);
  return object;
}

Json json(const GraphicsCheck& graphics) {
  Json candidates = Json::array();
  for (std::size_t i = 0; i < graphics.candidates.size(); ++i) {
    candidates.push_back(json(graphics.candidates[i], graphics.byDefault == i));
  }
  return {{"library_failure", json(graphics.library)},
          {"devices_failure", json(graphics.devices)},
          {"displays", candidates}};
}

Json json(const video::EncoderCheck& check) {
  return {{"format", nameOf(check.format)},
          {"encoder", orNull(check.found)},
          {"error", orNull(check.failure)}};
}

Json json(const FolderCheck& folder) {
  return {{"path", folder.path.string()},
          {"free_bytes", folder.freeBytes},
          {"error", orNull(folder.failure)}};
}

Json json(const Problem& problem) {
  return {{"what", problem.what}, {"remedy", problem.remedy}};
}

}  // namespace

void reportCheckup(const Checkup& checkup, std::ostream& out) {
  fmt::print(out, "rotatebook {}\n\n", kVersion);
  printGraphics(checkup.graphics, out);
  printRest(checkup, out);
  printProblems(checkup.problems, out);
  fmt::print(out, "\n{}\n", verdict(checkup));
}

void reportCheckupAsJson(const Checkup& checkup, std::ostream& out) {
  const auto asJson = [](const auto& part) { return json(part); };
  out << jsonLine({{"ready", checkup.ready()},
                   {"version", kVersion},
                   {"graphics", json(checkup.graphics)},
                   {"encoders", arrayOf(checkup.encoders, asJson)},
                   {"font_error", orNull(checkup.fontFailure)},
                   {"folder", json(checkup.folder)},
                   {"cores", checkup.cores},
                   {"memory_bytes", checkup.memory},
                   {"problems", arrayOf(checkup.problems, asJson)}});
}

}  // namespace rotatebook::diagnose
