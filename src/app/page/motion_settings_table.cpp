#include "page/motion_settings_table.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "base/number_text.h"
#include "base/text.h"
#include "scene/correction_text.h"
#include "scene/names.h"

namespace rotatebook::page {
namespace {

constexpr int kSettingDigits = 4;

/// One setting of every motion; empty where a motion has none.
using Row = std::vector<std::string>;

std::string number(double value) {
  return roundedText(value, kSettingDigits);
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return fmt::format("({}, {}, {})", number(vector.x()), number(vector.y()), number(vector.z()));
}

std::string integratorText(const scene::Panel& motion) {
  if (!physics::takesSteps(motion.simulation.model)) {
    return motion.simulation.model == physics::Model::Exact ? "closed form" : "recorded";
  }
  return joined({std::string(scene::nameOf(scene::kIntegrators, motion.simulation.integrator)),
                 joined(scene::correctionTexts(motion.simulation))});
}

std::string stepText(const scene::Panel& motion) {
  if (!physics::takesSteps(motion.simulation.model)) return "";
  return number(1e3 * motion.simulation.steps().length()) + " ms";
}

std::string springsText(const scene::Panel& motion) {
  const physics::SimulationSettings& settings = motion.simulation;
  if (settings.model != physics::Model::Particles) return "";
  return fmt::format("{} N/m, {}", number(settings.stiffness),
                     settings.damping > 0 ? "damping " + number(settings.damping) : "undamped");
}

std::string dissipationText(const scene::Panel& motion) {
  const physics::SimulationSettings& settings = motion.simulation;
  return settings.dissipates() ? number(settings.dissipation) + " kg m² s" : "";
}

std::string spinText(const scene::Panel& motion) {
  const physics::InitialSpin& spin = motion.initial;
  const bool isVelocity = spin.kind == physics::InitialSpin::Kind::AngularVelocity;
  return (isVelocity ? "ω = " : "L = ") + vectorText(spin.value) +
         (isVelocity ? " rad/s" : " kg m²/s");
}

std::string tiltText(const scene::Panel& motion) {
  const auto& tilt = motion.initial.tilt;
  if (!tilt) return "none";
  return fmt::format("{} rad toward {}", number(tilt->angle),
                     scene::nameOf(scene::kAxes, tilt->axis));
}

std::string bodyText(const scene::Panel& motion) {
  const Eigen::Vector3d size = 1e3 * motion.body.size;
  return fmt::format("{} × {} × {} mm, {} kg{}", number(size.x()), number(size.y()),
                     number(size.z()), number(motion.body.mass),
                     motion.inertia ? ", own inertia tensor" : "");
}

Html cells(const char* tag, const Row& row) {
  Html html;
  for (const std::string& text : row)
    html.text += fmt::format("<{0}>{1}</{0}>", tag, escaped(text.empty() ? "–" : text).text);
  return html;
}

Html rowHtml(const std::string& name, const Html& content) {
  return {fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>\n", escaped(name).text, content.text)};
}

/// Returns whether there are more motions than side by side have room: those of a grid.
bool isGrid(const std::vector<scene::Panel>& motions) {
  constexpr std::size_t kMaxColumns = 6;
  return motions.size() > kMaxColumns;
}

/// Returns the texts that aren't empty, each once.
std::string listOnce(const Row& texts) {
  Row once;
  for (const std::string& text : texts) {
    if (!text.empty() && std::ranges::count(once, text) == 0) once.push_back(text);
  }
  return joined(once);
}

/// Returns a row of the `text` of each motion, or of all different ones of a grid; no row if all
/// texts are empty.
template <typename Text>
Html rowOf(const std::string& name, const std::vector<scene::Panel>& motions, const Text& text) {
  Row row;
  bool any = false;
  for (const scene::Panel& motion : motions) {
    row.push_back(text(motion));
    any = any || !row.back().empty();
  }
  if (isGrid(motions)) row = {listOnce(row)};
  return any ? rowHtml(name, cells("td", row)) : Html{};
}

Html headOf(const std::vector<scene::Panel>& motions) {
  if (motions.size() == 1 || isGrid(motions)) return {};
  Row labels;
  for (const scene::Panel& motion : motions) labels.push_back(motion.label);
  return {fmt::format("<thead><tr><td></td>{}</tr></thead>\n", cells("th", labels).text)};
}

}  // namespace

Html settingsTable(const std::vector<scene::Panel>& motions, const scene::ClipSettings& clip) {
  Html rows = rowOf("Model", motions, [](const scene::Panel& motion) {
    return std::string(scene::nameOf(scene::kModels, motion.simulation.model));
  });
  rows += rowOf("Integrator", motions, &integratorText);
  rows += rowOf("Step", motions, &stepText);
  rows += rowOf("Springs", motions, &springsText);
  rows += rowOf("Dissipation", motions, &dissipationText);
  rows += rowOf("Spin", motions, &spinText);
  rows += rowOf("Tilt", motions, &tiltText);
  rows += rowOf("Book", motions, &bodyText);
  const std::string picture =
      fmt::format("{} × {}, {} frames/s", clip.width, clip.height, clip.frameRate.text());
  rows += rowHtml("Picture",
                  {fmt::format("<td colspan=\"{}\">{}</td>", isGrid(motions) ? 1 : motions.size(),
                               escaped(picture).text)});
  return {fmt::format(
      "<div class=\"scroll\" tabindex=\"0\"><table "
      "class=\"settings\">\n<caption>Settings</caption>\n{}<tbody>\n{}</tbody></table></div>\n",
      headOf(motions).text, rows.text)};
}

}  // namespace rotatebook::page
