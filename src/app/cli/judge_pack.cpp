#include "cli/judge_pack.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/version.h"
#include "cli/input_guard.h"
#include "physics/trajectory.h"
#include "scene/scene_text.h"
#include "system/atomic_file.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

/// A motion of a pack.
struct PackRow {
  std::string_view name, about;
  std::array<double, 3> inertia;  ///< About the body's axes x, y, z. [kg m^2]
  std::array<double, 3> spin;  ///< At the start, where body and world have the same axes. [rad/s]
};

constexpr std::array<PackRow, 4> kRows{
    {{"book",
      "a book of 1 kg thrown half a degree off its middle axis: it tumbles",
      {0.00726, 0.00315, 0.00999},
      {5, 0.05, 0}},
     // A bar of 60 g and 10 cm, and a stem of 30 g and 5 cm, along x.
     {"t-handle",
      "a T-handle spun about its stem, as on the space station: it turns over",
      {5e-5, 1.875e-5, 6.875e-5},
      {12, 0.01, 0}},
     {"disc",
      "a plate thrown with a wobble: it wobbles twice as fast as it turns",
      {5.625e-4, 5.625e-4, 1.125e-3},
      {0.5, 0, 15}},
     {"near-separatrix",
      "the book, off its middle axis by a ten thousandth of a degree: it waits long",
      {0.00726, 0.00315, 0.00999},
      {5, 1e-5, 0}}}};
// Measured with 240 steps a second: Runge and Kutta's method is off by up to 2e-4 degrees, near the
// separatrix by 0.014; Euler's by 74 and more, and one without the gyroscopic torque by 3.8 and
// more.
constexpr double kErrorBound = 1;     // On the angle to the exact attitude. [degrees]
constexpr double kDriftBound = 1e-3;  // On the relative drift of energy and |L|.
constexpr int kSeconds = 20, kStatesASecond = 5;

constexpr std::string_view kJsonBeginning = "{\"pack\":";
constexpr std::string_view kTableBeginning = "t (s),qw,qx,qy,qz,wx (rad/s),wy (rad/s),wz (rad/s)\n";

/// Returns the exact motion.
physics::Trajectory exactMotion(const PackRow& row) {
  const auto listOf = [](const std::array<double, 3>& numbers) {
    return fmt::format("[{}]", joinedOf(numbers, shortestText));
  };
  const std::string text = fmt::format(
      "[simulation]\nmodel = \"exact\"\n[body]\ninertia = {}\n[initial]\nangular_velocity = {}\n"
      "[clip]\nfps = {}\nduration = {}\n",
      listOf(row.inertia), listOf(row.spin), kStatesASecond,
      shortestText(kSeconds + 1.0 / kStatesASecond));
  const scene::Scene scene = scene::parseScene(text, std::string(row.name) + ".toml");
  return timeline::simulateScene(scene).trajectories().front();
}

/// Returns the numbers of a table's row.
std::array<double, 8> numbersOf(const physics::Sample& sample) {
  const auto& q = sample.attitude;
  const auto& spin = sample.angularVelocity;
  return {sample.time, q.w(), q.x(), q.y(), q.z(), spin.x(), spin.y(), spin.z()};
}

std::string tableOf(const physics::Trajectory& motion) {
  std::string table(kTableBeginning);
  for (const physics::Sample& sample : motion.samples) {
    std::string line;
    for (const double number : numbersOf(sample))
      line += (line.empty() ? "" : ",") + shortestText(number);
    table += line + '\n';
  }
  return table;
}

Json rowJson(const PackRow& row, const physics::Trajectory& motion) {
  return {
      {"name", row.name},
      {"about", row.about},
      {"table", fmt::format("{}.csv", row.name)},
      {"inertia", row.inertia},
      {"bounds",
       {{"error_deg", kErrorBound}, {"energy_drift", kDriftBound}, {"L_drift", kDriftBound}}},
      {"columns", {"t", "qw", "qx", "qy", "qz", "wx", "wy", "wz"}},
      {"states", arrayOf(motion.samples, [](const auto& sample) { return numbersOf(sample); })}};
}

}  // namespace

void writePack(const std::filesystem::path& folder) {
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  Json motions = Json::array();
  for (const PackRow& row : kRows) {
    const physics::Trajectory motion = exactMotion(row);
    const std::filesystem::path table = folder / fmt::format("{}.csv", row.name);
    requireAbsentOr(table, kTableBeginning);
    files.emplace_back(table, tableOf(motion));
    motions.push_back(rowJson(row, motion));
  }
  const std::filesystem::path index = folder / "pack.json";
  requireAbsentOr(index, kJsonBeginning);
  const Json pack{{"pack", "free rigid bodies, exact"},
                  {"version", kVersion},
                  {"units",
                   "s, rad/s, kg m^2; attitudes turn the body into the world, rates are along the "
                   "world's axes"},
                  {"motions", motions}};
  files.emplace_back(index, jsonLine(pack));
  system::createFolders(folder);
  for (const auto& [file, content] : files) system::writeFileAtomically(file, content);
}

}  // namespace rotatebook::cli
