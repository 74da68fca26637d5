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

/// Texts of a motion's settings in a language.
struct Texts {
  const Language& say;

  std::string number(double value) const { return say.numbers(roundedText(value, kSettingDigits)); }

  /// Has semicolons between the numbers if the decimal mark is a comma.
  std::string vector(const Eigen::Vector3d& vector) const {
    const std::string_view between = say.numbers("0.5") == "0,5" ? "; " : ", ";
    return fmt::format(
        "({})", joined({number(vector.x()), number(vector.y()), number(vector.z())}, between));
  }

  std::string model(const scene::Panel& motion) const {
    return say(scene::nameOf(scene::kModels, motion.simulation.model));
  }

  std::string integrator(const scene::Panel& motion) const {
    if (!physics::takesSteps(motion.simulation.model)) {
      return motion.simulation.model == physics::Model::Exact ? say("closed form")
                                                              : say("recorded");
    }
    const scene::Words words = say.ofPictures.value_or(scene::Words{});
    return joined({say(scene::nameOf(scene::kIntegrators, motion.simulation.integrator)),
                   joined(scene::correctionTexts(motion.simulation, words))});
  }

  std::string step(const scene::Panel& motion) const {
    if (!physics::takesSteps(motion.simulation.model)) return "";
    return number(1e3 * motion.simulation.steps().length()) + " ms";
  }

  std::string springs(const scene::Panel& motion) const {
    const physics::SimulationSettings& settings = motion.simulation;
    if (settings.model != physics::Model::Particles) return "";
    return number(settings.stiffness) + " N/m, " +
           (settings.damping > 0 ? say("damping {number}", {{"number", number(settings.damping)}})
                                 : say("undamped"));
  }

  std::string dissipation(const scene::Panel& motion) const {
    const physics::SimulationSettings& settings = motion.simulation;
    return settings.dissipates() ? number(settings.dissipation) + " kg m² s" : "";
  }

  std::string spin(const scene::Panel& motion) const {
    const physics::InitialSpin& spin = motion.initial;
    const bool isVelocity = spin.kind == physics::InitialSpin::Kind::AngularVelocity;
    return (isVelocity ? "ω = " : "L = ") + vector(spin.value) +
           (isVelocity ? " rad/s" : " kg m²/s");
  }

  std::string tilt(const scene::Panel& motion) const {
    const auto& tilt = motion.initial.tilt;
    if (!tilt) return say("none");
    return say("{angle} rad toward {axis}",
               {{"angle", number(tilt->angle)},
                {"axis", std::string(scene::nameOf(scene::kAxes, tilt->axis))}});
  }

  std::string body(const scene::Panel& motion) const {
    const Eigen::Vector3d size = 1e3 * motion.body.size;
    return fmt::format("{} × {} × {} mm, {} kg", number(size.x()), number(size.y()),
                       number(size.z()), number(motion.body.mass)) +
           (motion.inertia ? ", " + say("own inertia tensor") : "");
  }
};

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

Html settingsTable(const std::vector<scene::Panel>& motions, const scene::ClipSettings& clip,
                   const Language& say) {
  const Texts texts{say};
  Html rows;
  const auto add = [&](const std::string& name,
                       std::string (Texts::*text)(const scene::Panel&) const) {
    rows += rowOf(name, motions, [&](const scene::Panel& motion) { return (texts.*text)(motion); });
  };
  add(say("Model"), &Texts::model);
  add(say("Integrator"), &Texts::integrator);
  add(say("Step"), &Texts::step);
  add(say("Springs"), &Texts::springs);
  add(say("Dissipation"), &Texts::dissipation);
  add(say("Spin"), &Texts::spin);
  add(say("Tilt"), &Texts::tilt);
  add(say("Book"), &Texts::body);
  const std::string picture = say(
      "{size}, {rate} frames/s",
      {{"size", fmt::format("{} × {}", clip.width, clip.height)}, {"rate", clip.frameRate.text()}});
  rows += rowHtml(say("Picture"),
                  {fmt::format("<td colspan=\"{}\">{}</td>", isGrid(motions) ? 1 : motions.size(),
                               escaped(picture).text)});
  return {fmt::format(
      "<div class=\"scroll\" tabindex=\"0\"><table "
      "class=\"settings\">\n<caption>{}</caption>\n{}<tbody>\n{}</tbody></table></div>\n",
      escaped(say("Settings")).text, headOf(motions).text, rows.text)};
}

}  // namespace rotatebook::page
