#include "scene/resolve.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

constexpr const char* kCylinder = "[body]\nshape = 'cylinder'\ndimensions = { radius = 0.1 }\n";

/// What follows from the statement of a scene, where all that follows is taken from it.
Scene resolvedAgain(const Scene& scene) {
  Spec spec = scene;
  const auto forget = [](Motion& motion) {
    motion.simulation.timePerFrame = 1;
    motion.simulation.substepped.reset();
    motion.particles = {};
    if (motion.initial.about) motion.initial.value.setZero();
    if (motion.solid.isBook()) return;
    motion.body = {};
    motion.inertia.reset();
  };
  for (Panel& motion : spec.motions) forget(motion);
  for (StudyRun& run : spec.runs) forget(run.motion);
  return resolve(spec, {});
}

TEST(Resolve, NeedsWhatIsStatedAlone) {
  const std::string particles =
      "[simulation]\nmodel = 'particles'\nparticles = 'grid:4'\nsubsteps = 1000\n";
  for (const std::string& lines :
       {std::string("[clip]\nspeed = 0.5\n"), kCylinder + particles,
        kCylinder + std::string("[[panel]]\nlabel = 'a'\nsimulation.model = 'exact'\n"
                                "[[panel]]\nlabel = 'b'\nbody.dimensions = { radius = 0.2 }\n"),
        kCylinder +
            std::string("[grid]\nrows = { key = 'body.dimensions.radius', values = [1, 2] }\n"
                        "columns = { key = 'initial.angular_velocity.0', values = "
                        "[1, 2] }\n"),
        kCylinder + particles +
            "[study]\nmeasure = ['stretch']\ninterval = 0.25\n"
            "x = { key = 'body.mass', values = [1, 2] }\n"}) {
    SCOPED_TRACE(lines);
    const Scene scene = sceneFrom(lines);
    EXPECT_EQ(resolvedAgain(scene), scene);
  }
}

TEST(Resolve, GivesTheLocationsOfWhatIsStated) {
  Spec spec = sceneFrom(kCylinder);
  spec.motions[0].solid.parts[0].lengths = {};
  try {
    resolve(spec, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("a.toml:3:14: ")) << error.what();
  }
}

}  // namespace
}  // namespace rotatebook::scene
