// The maps that come with the program, small: each finds what it must, and its twin doesn't.
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kMaps = fs::path(ROTATEBOOK_SOURCE) / "scenes/maps";

class ShippedMap : public ProgramTest {
 protected:
  ChildResult map(const std::string& name, const std::string& size,
                  const std::vector<std::string>& overrides = {}) const {
    std::vector<std::string> arguments{"map", (kMaps / (name + ".toml")).string(), "--set",
                                       "map.size=" + size};
    for (const std::string& change : overrides) {
      arguments.insert(arguments.end(), {"--set", change});
    }
    return run(arguments);
  }

  void expectMet(const std::string& name, const std::string& size) const {
    const ChildResult result = map(name, size);
    EXPECT_EQ(result.status, 0) << result.output << result.error;
    EXPECT_TRUE(has("out/" + name + ".png"));
  }

  void expectUnmet(const std::string& name, const std::string& size,
                   const std::vector<std::string>& overrides) const {
    const ChildResult result = map(name, size, overrides);
    EXPECT_EQ(result.status, 1) << result.output << result.error;
    EXPECT_THAT(result.output, HasSubstr("\n  not met  "));
  }
};

TEST_F(ShippedMap, OfTheDelay) {
  expectMet("map-delay", "[160, 90]");
}

TEST_F(ShippedMap, OfTheDelayFindsNoneAboutAStableAxis) {
  expectUnmet("map-delay", "[160, 90]", {"initial.angular_velocity=[0, 5, 0]"});
}

TEST_F(ShippedMap, OfAllThrows) {
  expectMet("map-throws", "[160, 80]");
}

TEST_F(ShippedMap, OfAllThrowsFindsNoEyesOfASphere) {
  expectUnmet("map-throws", "[160, 80]", {"body.inertia=[1, 1, 1]"});
}

TEST_F(ShippedMap, OfHalfTurns) {
  expectMet("map-half-turns", "[60, 60]");
}

TEST_F(ShippedMap, OfHalfTurnsFindsNoKiteOfAnotherMethod) {
  expectUnmet("map-half-turns", "[60, 60]", {"panel.0.simulation.integrator=rk4"});
}

TEST_F(ShippedMap, OfLuck) {
  expectMet("map-luck", "[40, 50]");
}

TEST_F(ShippedMap, OfLuckFindsNoneOfABetterMethod) {
  expectUnmet("map-luck", "[40, 50]", {"panel.0.simulation.integrator=rk4"});
}

TEST_F(ShippedMap, OfAllBodies) {
  expectMet("map-bodies", "[240, 144]");
}

TEST_F(ShippedMap, OfAllBodiesKnowsAnotherBook) {
  expectUnmet("map-bodies", "[240, 144]", {"map.marks=[]", "map.expect.0.at=[0.6, 0.8]"});
}

TEST_F(ShippedMap, OfExplosions) {
  expectMet("map-explosion", "[40, 25]");
}

TEST_F(ShippedMap, OfExplosionsFindsNoneOfVerlet) {
  expectUnmet("map-explosion", "[40, 25]",
              {"simulation.integrator=verlet", "simulation.damping=0"});
}

}  // namespace
}  // namespace rotatebook::cli::testing
