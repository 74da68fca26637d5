#include "page/motion_settings_table.h"

#include <string>

#include <gtest/gtest.h>

namespace rotatebook::page {
namespace {

using physics::Integrator;
using physics::Model;

/// Every number another.
scene::Panel particles() {
  scene::Panel panel;
  panel.label = "soft & wet";
  panel.body.size = {0.15, 0.22, 0.041};
  panel.body.mass = 1.3;
  panel.simulation.model = Model::Particles;
  panel.simulation.integrator = Integrator::Verlet;
  panel.simulation.substeps = 8;
  panel.simulation.timePerFrame = 0.02;
  panel.simulation.normalizeEvery = 0;
  panel.simulation.stiffness = 3456;
  panel.simulation.damping = 0.7;
  panel.initial.value = {5, 0.25, -1};
  panel.initial.tilt = physics::Tilt{0.1, 2};
  return panel;
}

scene::Panel rigid(Model model) {
  scene::Panel panel;
  panel.label = "stiff";
  panel.body.size = {0.1, 0.2, 0.03};
  panel.body.mass = 2;
  panel.inertia = Eigen::Matrix3d::Identity();
  panel.simulation.model = model;
  panel.simulation.integrator = Integrator::Rk4;
  panel.simulation.substeps = 3;
  panel.simulation.timePerFrame = 0.01;
  panel.initial.kind = physics::InitialSpin::Kind::AngularMomentum;
  panel.initial.value = {0.01, 0.02, 0.03};
  return panel;
}

scene::ClipSettings clip() {
  scene::ClipSettings settings;
  settings.width = 640;
  settings.height = 360;
  settings.frameRate = {30000, 1001};
  return settings;
}

/// The table around these rows.
std::string tableOf(const std::string& head, const std::string& rows) {
  return "<div class=\"scroll\" tabindex=\"0\"><table class=\"settings\">\n"
         "<caption>Settings</caption>\n" +
         head + "<tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string row(const std::string& name, const std::string& cells) {
  return "<tr><th scope=\"row\">" + name + "</th>" + cells + "</tr>\n";
}

TEST(SettingsTable, HasEverySettingOfAMotion) {
  EXPECT_EQ(settingsTable({particles()}, clip()).text,
            tableOf("", row("Model", "<td>particles</td>") +
                            row("Integrator", "<td>verlet, not normalised</td>") +
                            row("Step", "<td>2.5 ms</td>") +
                            row("Springs", "<td>3456 N/m, damping 0.7</td>") +
                            row("Spin", "<td>ω = (5, 0.25, -1) rad/s</td>") +
                            row("Tilt", "<td>0.1 rad toward z</td>") +
                            row("Book", "<td>150 × 220 × 41 mm, 1.3 kg</td>") +
                            row("Picture",
                                "<td colspan=\"1\">640 × 360, "
                                "30000/1001 frames/s</td>")));
}

TEST(SettingsTable, HasTheDissipationOfABodyThatLosesEnergy) {
  scene::Panel panel = rigid(Model::Quaternion);
  panel.simulation.dissipation = 2e-6;
  EXPECT_NE(settingsTable({panel}, clip()).text.find(row("Dissipation", "<td>2e-06 kg m² s</td>")),
            std::string::npos);
}

TEST(SettingsTable, HasAColumnForEachMotion) {
  EXPECT_EQ(
      settingsTable({particles(), rigid(Model::Quaternion)}, clip()).text,
      tableOf("<thead><tr><td></td><th>soft &amp; wet</th><th>stiff</th></tr></thead>\n",
              row("Model", "<td>particles</td><td>quaternion</td>") +
                  row("Integrator", "<td>verlet, not normalised</td><td>rk4, normalised</td>") +
                  row("Step", "<td>2.5 ms</td><td>3.333 ms</td>") +
                  row("Springs", "<td>3456 N/m, damping 0.7</td><td>–</td>") +
                  row("Spin",
                      "<td>ω = (5, 0.25, -1) rad/s</td>"
                      "<td>L = (0.01, 0.02, 0.03) kg m²/s</td>") +
                  row("Tilt", "<td>0.1 rad toward z</td><td>none</td>") +
                  row("Book",
                      "<td>150 × 220 × 41 mm, 1.3 kg</td>"
                      "<td>100 × 200 × 30 mm, 2 kg, own inertia tensor</td>") +
                  row("Picture", "<td colspan=\"2\">640 × 360, 30000/1001 frames/s</td>")));
}

TEST(SettingsTable, LeavesOutWhatNoMotionHas) {
  EXPECT_EQ(settingsTable({rigid(Model::Exact)}, clip()).text,
            tableOf("", row("Model", "<td>exact</td>") + row("Integrator", "<td>closed form</td>") +
                            row("Spin", "<td>L = (0.01, 0.02, 0.03) kg m²/s</td>") +
                            row("Tilt", "<td>none</td>") +
                            row("Book", "<td>100 × 200 × 30 mm, 2 kg, own inertia tensor</td>") +
                            row("Picture",
                                "<td colspan=\"1\">640 × 360, "
                                "30000/1001 frames/s</td>")));
}

}  // namespace
}  // namespace rotatebook::page
