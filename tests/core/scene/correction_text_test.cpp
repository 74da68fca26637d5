#include "scene/correction_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> textsOf(const std::string& simulation) {
  return correctionTexts(sceneFrom("[simulation]\n" + simulation).motions[0].simulation);
}

TEST(CorrectionTexts, SayHowOftenAMotionIsNormalised) {
  EXPECT_THAT(textsOf("normalize = true"), ElementsAre("normalised"));
  EXPECT_THAT(textsOf("normalize = false"), ElementsAre("not normalised"));
  EXPECT_THAT(textsOf("normalize = { every = 100 }"), ElementsAre("normalised every 100 steps"));
}

TEST(CorrectionTexts, TellTheParticlesRemediesApart) {
  EXPECT_THAT(textsOf("model = 'particles'"), ElementsAre("normalised"));
  EXPECT_THAT(textsOf("model = 'particles'\nnormalize_energy = false"),
              ElementsAre("energy not normalised", "drift removed"));
  EXPECT_THAT(textsOf("model = 'particles'\nnormalize = false\nremove_drift = { every = 7 }"),
              ElementsAre("energy not normalised", "drift removed every 7 steps"));
}

TEST(CorrectionTexts, LeaveOutThoseOfParticlesForARigidModel) {
  EXPECT_THAT(textsOf("normalize_energy = false"), ElementsAre("normalised"));
}

}  // namespace
}  // namespace rotatebook::scene
