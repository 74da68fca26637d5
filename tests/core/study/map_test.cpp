// Maps: each value against a motion that is simulated by itself.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "physics/simulate.h"
#include "scene/scene_text.h"
#include "study/map_files.h"
#include "study/map_result.h"
#include "study/map_runs.h"
#include "study/reduced.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;
using scene::Outcome;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kX = "x = { key = 'simulation.substeps', from = 1, to = 6 }\n";
constexpr const char* kTilt =
    "y = { key = 'initial.tilt.0', from = 1e-4, to = 1, scale = 'log' }\n";

/// A book that flips for two seconds, and the lines of its map.
scene::Scene sceneOf(const std::string& lines, const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "[simulation]\nintegrator = 'euler'\ntime_per_frame = 0.05\nsubsteps = 3\n"
      "[initial]\nangular_velocity = [8, 0, 0]\ntilt = [0.01, 'z']\n"
      "[clip]\nfps = 20\nduration = 2.05\n[map]\n" +
          lines,
      "a.toml", overrides);
}

scene::Scene overTiltAndSteps(const std::string& lines) {
  return sceneOf(std::string(kX) + kTilt + "size = [5, 4]\n" + lines);
}

MapResult mapResultOf(const scene::Scene& scene) {
  const MapRuns runs(scene);
  MapResult result = emptyResult(scene, runs);
  for (const MapTile& tile : runs.tiles()) {
    putTile(tile, runs.valuesOf(tile), *scene.map, result);
  }
  return result;
}

/// The motion at a pixel of overTiltAndSteps().
MotionSettings motionAt(const scene::Scene& scene, int x, int y) {
  MotionSettings motion = scene.motions[0].motion();
  motion.simulation.substeps = static_cast<int>(std::round(scene.map->x.at(x, scene.map->width)));
  motion.initial.tilt->angle = scene.map->y.at(y, scene.map->height);
  return motion;
}

/// Expects of each pixel what `measure` says of its motion, of 41 samples.
template <typename Measure>
void expectEach(const scene::Scene& scene, const Measure& measure) {
  const MapResult result = mapResultOf(scene);
  std::set<double> different;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      const MotionSettings motion = motionAt(scene, x, y);
      const double expected = measure(simulate(motion, 41), motion);
      EXPECT_EQ(result.values[0][static_cast<std::size_t>(y * 5 + x)], expected) << x << " " << y;
      different.insert(expected);
    }
  }
  EXPECT_GT(different.size(), 2U) << "the test shows little";
}

TEST(Map, HasTheHalfTurnsOfEachMotion) {
  expectEach(overTiltAndSteps("measure = 'half_turns'"),
             [](const Trajectory& motion, const auto&) { return motion.samples.back().halfTurns; });
}

TEST(Map, HasTheErrorAtTheEnd) {
  expectEach(overTiltAndSteps("measure = 'error_deg'"),
             [](const Trajectory& motion, const auto&) { return motion.samples.back().errorDeg; });
}

TEST(Map, HasTheLargestErrorAsStudiesMeasureIt) {
  expectEach(overTiltAndSteps("measure = 'error_deg'\nmoment = 'largest'"),
             [](const Trajectory& motion, const MotionSettings& settings) {
               return reduced(motion, settings, scene::Measure::ErrorDeg);
             });
}

TEST(Map, HasTheDriftOfTheEnergy) {
  expectEach(overTiltAndSteps("measure = 'energy_drift'"),
             [](const Trajectory& motion, const auto&) {
               return std::fabs(motion.samples.back().total() / motion.samples.front().total() - 1);
             });
}

TEST(Map, HasTheTimeOfTheFirstHalfTurnOrNever) {
  expectEach(overTiltAndSteps("measure = 'first_flip'"), [](const Trajectory& motion, const auto&) {
    for (const physics::Sample& sample : motion.samples) {
      if (sample.halfTurns > 0) return sample.time;
    }
    return kNever;
  });
}

TEST(Map, HasTheTimeBetweenFlips) {
  expectEach(overTiltAndSteps("measure = 'flip_interval'"),
             [](Trajectory motion, const MotionSettings& settings) {
               motion.samples.pop_back();
               const double mean = physics::meanInterval(flipTimes(motion, modelInertia(settings)));
               return std::isnan(mean) ? kNever : mean;
             });
}

TEST(Map, LooksWhereItIsToldAndAtTheEnd) {
  const scene::Scene scene = sceneOf(
      std::string("x = { key = 'simulation.time_per_frame', from = 0.01, to = 0.1 }\n") + kTilt +
      "size = [3, 3]\nduration = 1.7\ninterval = 0.3\nmeasure = 'tilt_deg'\n"
      "moment = 'largest'");
  const MapResult result = mapResultOf(scene);
  MotionSettings motion = scene.motions[0].motion();
  motion.simulation.timePerFrame = scene.map->x.at(2, 3);
  motion.initial.tilt->angle = scene.map->y.at(1, 3);
  const std::vector<double> times{0, 0.3, 0.6, 3 * 0.3, 1.2, 1.5, 1.7};
  EXPECT_EQ(result.values[0][1 * 3 + 2],
            reduced(simulate(motion, times), motion, scene::Measure::TiltDeg));
}

TEST(Map, TellsWhenParticlesDiverge) {
  const scene::Scene scene =
      sceneOf("x = { key = 'simulation.stiffness', from = 1, to = 4000 }\n" + std::string(kTilt) +
                  "size = [3, 2]\nmeasure = 'diverges_at'",
              {"simulation.model=particles", "simulation.normalize=false", "simulation.substeps=1",
               "simulation.damping=0"});
  const MapResult result = mapResultOf(scene);
  MotionSettings motion = scene.motions[0].motion();
  motion.simulation.stiffness = scene.map->x.at(2, 3);
  motion.initial.tilt->angle = scene.map->y.at(0, 2);
  const auto diverged = simulate(motion, 41).divergedAt;
  ASSERT_TRUE(diverged);
  EXPECT_EQ(result.values[0][2], *diverged);
  const MapResult turns =
      mapResultOf(sceneOf("x = { key = 'simulation.stiffness', from = 1, to = 4000 }\n" +
                              std::string(kTilt) + "size = [3, 2]\nmeasure = 'half_turns'",
                          {"simulation.model=particles", "simulation.normalize=false",
                           "simulation.substeps=1", "simulation.damping=0"}));
  EXPECT_EQ(outcomeOf(turns.values[0][2]), Outcome::Diverged);
}

TEST(Map, MakesOneMotionOfEachLineOverTime) {
  for (const bool isAcross : {true, false}) {
    const std::string time = " = { key = 'time', from = 0, to = 2 }\n";
    const std::string mass = " = { key = 'initial.tilt.0', from = 0.1, to = 0.5 }\n";
    const scene::Scene scene = sceneOf((isAcross ? "x" : "y") + time + (isAcross ? "y" : "x") +
                                       mass + "size = [3, 4]\nmeasure = 'tilt_deg'");
    const MapResult result = mapResultOf(scene);
    const int count = isAcross ? 3 : 4, line = 1;
    MotionSettings motion = scene.motions[0].motion();
    motion.initial.tilt->angle =
        (isAcross ? scene.map->y : scene.map->x).at(line, isAcross ? 4 : 3);
    for (int i = 0; i < count; ++i) {
      const std::vector<double> times{0, 2 * (i + 0.5) / count};
      const auto pixel = static_cast<std::size_t>(isAcross ? line * 3 + i : i * 3 + line);
      EXPECT_EQ(result.values[0][pixel], simulate(motion, times).samples.back().tiltDeg) << i;
    }
  }
}

TEST(Map, TurnsTheSpin) {
  const scene::Scene scene = scene::parseScene(
      "[simulation]\nmodel = 'exact'\n[initial]\nangular_velocity = [0, 8, 0]\n[map]\n"
      "x = { key = 'spin.longitude', from = -180, to = 180 }\n"
      "y = { key = 'spin.latitude', from = -90, to = 90 }\n"
      "size = [4, 3]\nmeasure = 'turned_deg'\nduration = 1.5",
      "a.toml");
  const MapResult result = mapResultOf(scene);
  MotionSettings motion = scene.motions[0].motion();
  motion.initial.value = 8 * Eigen::Vector3d(std::cos(1.0471975511965976) * std::sqrt(0.5),
                                             std::cos(1.0471975511965976) * std::sqrt(0.5),
                                             std::sin(1.0471975511965976));
  const std::vector<double> times{0, 1.5};
  const physics::Sample end = simulate(motion, times).samples.back();
  const Eigen::Vector3d line = motion.initial.value.normalized();
  const double turned = std::acos(line.dot(end.attitude * line)) * 180 / 3.14159265358979;
  EXPECT_GT(turned, 10);
  EXPECT_NEAR(result.values[0][2 * 4 + 2], turned, 1e-6) << "longitude 45, latitude 60 degrees";
  EXPECT_NEAR(result.values[0][1 * 4 + 2], result.values[0][1 * 4], 1e-9) << "both ways round";
}

TEST(Map, RefusesBodiesThatCantBe) {
  const scene::Scene scene = sceneOf(
      "x = { key = 'moments.smallest', from = 0, to = 1 }\n"
      "y = { key = 'moments.middle', from = 0.5, to = 1 }\nsize = [10, 5]\nmeasure = 'growth'\n"
      "marks = [{ moments = [3, 1, 2.5], label = 'a' }]");
  const MapResult result = mapResultOf(scene);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 10; ++x) {
      const double i1 = scene.map->x.at(x, 10), i2 = scene.map->y.at(y, 5);
      const double value = result.values[0][static_cast<std::size_t>(y * 10 + x)];
      const bool canBe = i1 <= i2 && i1 + i2 >= 1 - 1e-12;
      ASSERT_EQ(outcomeOf(value), canBe ? Outcome::Value : Outcome::Refused) << i1 << " " << i2;
      if (canBe) {
        EXPECT_NEAR(value, std::sqrt((i2 - i1) * (1 - i2) / i1), 1e-12);
      }
    }
  }
  EXPECT_NEAR(result.marks[0].values[0], std::sqrt(1.5 * 0.5 / 3), 1e-12);
  EXPECT_EQ(result.marks[0].mark.x, 1.0 / 3);
}

TEST(Map, ComparesPanels) {
  const scene::Scene scene =
      sceneOf(std::string(kX) + kTilt +
                  "size = [4, 3]\nmeasure = 'half_turns'\n"
                  "[[panel]]\nlabel = 'euler'\nsimulation.model = 'quaternion'\n"
                  "[[panel]]\nlabel = 'exact, too'\nsimulation.model = 'exact'\n",
              {});
  const MapResult result = mapResultOf(scene);
  ASSERT_EQ(result.values.size(), 2U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(result.values[1][i], result.values[1][i / 4 * 4]) << "steps don't matter";
  }
  EXPECT_THAT(mapCsv(result, scene),
              StartsWith("panel,simulation.substeps,initial.tilt.0,half_turns,outcome\neuler,"));
  EXPECT_THAT(mapCsv(result, scene), HasSubstr("\n\"exact, too\","));
}

TEST(MapTiles, HoldEachPixelOnce) {
  for (const char* size : {"[100, 70]", "[2, 300]", "[33, 32]"}) {
    const scene::Scene scene =
        sceneOf(std::string(kX) + kTilt + "measure = 'half_turns'\nsize = " + size);
    std::vector<int> seen(static_cast<std::size_t>(scene.map->runs()), 0);
    for (const MapTile& tile : MapRuns(scene).tiles()) {
      for (int y = tile.bottom; y < tile.bottom + tile.height; ++y) {
        for (int x = tile.left; x < tile.left + tile.width; ++x) {
          ++seen[static_cast<std::size_t>(y * scene.map->width + x)];
        }
      }
    }
    EXPECT_EQ(std::ranges::count(seen, 1), scene.map->runs()) << size;
  }
}

TEST(MapTiles, StayFewOnLargeMaps) {
  const scene::Scene scene =
      sceneOf(std::string(kX) + kTilt + "measure = 'half_turns'\nsize = [10000, 10000]");
  EXPECT_LT(MapRuns(scene).tiles().size(), 1'300U);  // measured 1024
}

TEST(MapTiles, SpanAnAxisThatDoesntMatter) {
  const scene::Scene scene = sceneOf(std::string(kX) + kTilt +
                                     "measure = 'half_turns'\nsize = [100, 70]\n"
                                     "[[panel]]\nlabel = 'euler'\nsimulation.model = 'quaternion'\n"
                                     "[[panel]]\nlabel = 'exact'\nsimulation.model = 'exact'\n");
  const MapRuns runs(scene);
  const std::vector<MapTile> tiles = runs.tiles();
  ASSERT_EQ(tiles.size(), 12U + 3U);
  EXPECT_EQ(tiles[13], (MapTile{1, 0, 32, 100, 32}));
  const std::vector<double> values = runs.valuesOf(tiles[13]);
  ASSERT_EQ(values.size(), 3200U);
  const scene::MapSettings& map = *scene.map;
  for (int i = 0; i < 3200; i += 37) {
    const double x = map.x.at(i % 100, map.width), y = map.y.at(32 + i / 100, map.height);
    EXPECT_EQ(values[static_cast<std::size_t>(i)], runs.valueAt(1, x, y)) << i;
  }
  EXPECT_NE(std::ranges::min(values), std::ranges::max(values));
}

TEST(MapFacts, LeaveOutRunsWithoutAValue) {
  MapResult result;
  result.labels = {""};
  result.values = {{3, kNever, kDiverged, kRefused, -1, 4}};
  const MapFacts facts = factsOf(result);
  EXPECT_EQ(facts.runs, 6);
  EXPECT_EQ(facts.withValue(), 3);
  EXPECT_EQ(facts.smallest, -1);
  EXPECT_EQ(facts.largest, 4);
  EXPECT_EQ(facts.mean, 2);
}

TEST(MapExpectations, AreOfSharesExtremesAndValues) {
  const scene::Scene scene = overTiltAndSteps(
      "measure = 'half_turns'\nexpect = [{ of = 'largest', max = 99 }, { of = 'share', over = 0.5, "
      "max = 0.5 }, { of = 'share', outcome = 'refused', max = 0 }, "
      "{ of = 'value', at = [1, 1], min = 1 }]");
  const MapRuns runs(scene);
  MapResult result = emptyResult(scene, runs);
  result.values = {{0, 1, 2, kRefused}};
  const std::vector<ExpectedOfMap> all = expectedOf(result, *scene.map, runs);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].measured, 2);
  EXPECT_EQ(all[1].measured, 0.5);
  EXPECT_EQ(all[1].subject(), "share over 0.5");
  EXPECT_TRUE(all[1].isMet());
  EXPECT_EQ(all[2].measured, 0.25);
  EXPECT_FALSE(all[2].isMet());
  EXPECT_EQ(all[3].subject(), "value at [1, 1]");
  MotionSettings motion = scene.motions[0].motion();
  motion.simulation.substeps = 1;
  motion.initial.tilt->angle = 1;
  EXPECT_EQ(all[3].measured, simulate(motion, 41).samples.back().halfTurns);
}

TEST(MapFiles, AreArraysOfNumPy) {
  const scene::Scene scene = sceneOf(std::string(kX) + kTilt + "measure = 'regime'\nsize = [3, 2]");
  MapResult result = emptyResult(scene, MapRuns(scene));
  result.values[0] = {1.5, kNever, kDiverged, kRefused, -0.0, 1e-300};
  const std::string bytes = npyOf(result, *scene.map);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header =
      10 + static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ(header % 64, 0U);
  EXPECT_THAT(bytes.substr(10),
              StartsWith("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }"));
  EXPECT_EQ(bytes[header - 1], '\n');
  EXPECT_EQ(bytes.size(), header + 6 * 8);
  EXPECT_EQ(bytes.substr(header, 8), std::string("\0\0\0\0\0\0\xf8\x3f", 8)) << "1.5";
  MapResult again = emptyResult(scene, MapRuns(scene));
  ASSERT_TRUE(readNpy(bytes, *scene.map, again));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(std::isnan(again.values[0][i]), i == 3);
    if (i != 3) {
      EXPECT_EQ(again.values[0][i], result.values[0][i]);
    }
  }
  EXPECT_FALSE(readNpy(bytes.substr(0, bytes.size() - 1), *scene.map, again));
  EXPECT_FALSE(readNpy("", *scene.map, again));
}

TEST(MapFiles, SayWhatTheAxesAre) {
  const scene::Scene scene = sceneOf(std::string(kX) + kTilt + "measure = 'regime'\nsize = [5, 2]");
  const std::string json =
      jsonText(mapJson(mapResultOf(scene), scene, MapRuns(scene), {"F", "S", "C"}));
  EXPECT_THAT(json, HasSubstr("\"x\":{\"key\":\"simulation.substeps\",\"label\":null,\"from\":"
                              "1.0,\"to\":6.0,\"scale\":\"linear\",\"count\":5,\"first\":1.5,"
                              "\"last\":5.5}"));
  EXPECT_THAT(json, HasSubstr("\"fingerprint\":\"F\",\"scene_xxh128\":\"S\",\"npy_xxh128\":\"C\""));
  EXPECT_THAT(mapCsv(mapResultOf(scene), scene),
              StartsWith("simulation.substeps,initial.tilt.0,regime,outcome\n1.5,0.001"));
}

}  // namespace
}  // namespace rotatebook::study
