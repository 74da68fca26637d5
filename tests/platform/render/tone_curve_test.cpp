// The part of the shaders that all light of the book goes through, number by number.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "base/srgb.h"
#include "embedded/render.h"
#include "render/device/egl_context.h"
#include "render/gl/gl_handles.h"
#include "render/gl/shader_program.h"

namespace rotatebook::render {
namespace {

constexpr double kFloatBound = 1e-5;  // measured 5e-7, most of it digits that are left out here

/// Returns a shader that applies a function of tone_curve.frag.
std::string applying(const std::string& function) {
  return "#version 330 core\n"
         "uniform vec3 light;\n"
         "out vec4 colour;\n"
         "vec3 " +
         function +
         "(vec3 light);\n"
         "void main() { colour = vec4(" +
         function + "(light), 1.0); }\n";
}

/// Applies the tone curve on a picture of one pixel, of floating point.
class ToneCurve : public ::testing::Test {
 protected:
  ToneCurve() {
    glBindRenderbuffer(GL_RENDERBUFFER, colour_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, 1, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, buffer_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              colour_.name());
    glBindVertexArray(vertices_.name());
    glViewport(0, 0, 1, 1);
  }

  Eigen::Vector3d of(const Eigen::Vector3d& radiance) const { return applied(curve_, radiance); }
  Eigen::Vector3d encoded(const Eigen::Vector3d& light) const { return applied(encoding_, light); }
  Eigen::Vector3d pixelOf(const Eigen::Vector3d& radiance) const {
    return applied(pixel_, radiance);
  }
  double ofGrey(double radiance) const {
    const Eigen::Vector3d found = of(Eigen::Vector3d::Constant(radiance));
    EXPECT_EQ(found.x(), found.y());
    EXPECT_EQ(found.x(), found.z());
    return found.x();
  }

 private:
  static ShaderProgram programOf(const std::string& function) {
    const std::string apply = applying(function);
    return ShaderProgram("trial", wholePictureVertexShader(),
                         {std::string_view(apply), toneCurveFragmentShader()});
  }

  static Eigen::Vector3d applied(const ShaderProgram& program, const Eigen::Vector3d& light) {
    program.use();
    program.set("pictureSize", Eigen::Vector2f(1, 1));
    program.set("light", Eigen::Vector3f(light.cast<float>()));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::array<float, 4> pixel{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel.data());
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(pixel[3], 1);
    return {pixel[0], pixel[1], pixel[2]};
  }

  EglContext context_;
  GlRenderbuffer colour_;
  GlFramebuffer buffer_;
  GlVertexArray vertices_;
  ShaderProgram curve_ = programOf("toneMap");
  ShaderProgram encoding_ = programOf("encodedSrgb");
  ShaderProgram pixel_ = programOf("pixelColour");
};

TEST_F(ToneCurve, KeepsColoursButForTheReflectanceThatIsTakenOff) {
  EXPECT_EQ(ofGrey(0), 0);
  EXPECT_NEAR(ofGrey(0.05), 0.015625, kFloatBound);
  EXPECT_NEAR(ofGrey(0.5), 0.46, kFloatBound);
  EXPECT_NEAR(ofGrey(0.7), 0.66, kFloatBound);
  EXPECT_NEAR(ofGrey(0.78), 0.74, kFloatBound);
  EXPECT_LT((of({0.1, 0.3, 0.6}) - Eigen::Vector3d(0.06, 0.26, 0.56)).norm(), kFloatBound);
}

// From 0.8 on, where a curve that began at 0.75 would give 0.76 another value in the third digit.
TEST_F(ToneCurve, CompressesHighlights) {
  EXPECT_NEAR(ofGrey(0.8), 0.76, kFloatBound);
  EXPECT_NEAR(ofGrey(1), 0.869091, kFloatBound);
  EXPECT_NEAR(ofGrey(2), 0.96, kFloatBound);
  EXPECT_NEAR(ofGrey(100), 0.999421, kFloatBound);
}

TEST_F(ToneCurve, TakesTheHueFromHighlights) {
  const Eigen::Vector3d found = of({2, 1, 0.5});
  EXPECT_NEAR(found.x(), 0.96, kFloatBound);
  EXPECT_NEAR(found.y(), 0.534091, kFloatBound);
  EXPECT_NEAR(found.z(), 0.321136, kFloatBound);
}

// By the standard's formula, in steps of a fortieth of a level where the curve is steepest.
TEST_F(ToneCurve, EncodesSrgb) {
  constexpr double kLevels = 255, kBound = 0.0013 / kLevels;  // measured 0.00116
  double largest = 0;
  for (int step = 0; step <= 4000; ++step) {
    const double root = step / 4000.0;
    const Eigen::Vector3d light(root * root * root, root * root, root);
    const Eigen::Vector3d found = encoded(light);
    for (int i = 0; i < 3; ++i) {
      const double expected = rotatebook::encodedSrgb(static_cast<float>(light[i]));
      largest = std::max(largest, std::abs(found[i] - expected));
    }
  }
  EXPECT_LT(largest, kBound);
  RecordProperty("largest_in_levels", std::to_string(kLevels * largest));
}

TEST_F(ToneCurve, MakesPixelsOfAnyRadiance) {
  const Eigen::Vector3d colour(0.1, 0.3, 0.6);
  EXPECT_LT((pixelOf(colour) - encoded(of(colour))).norm(), kFloatBound);
  EXPECT_EQ(pixelOf({0, 0, 0}), Eigen::Vector3d::Zero());
  const Eigen::Vector3d white = pixelOf({1e6, 1e6, 1e6});
  EXPECT_NEAR(white.x(), 1, kFloatBound);
}

}  // namespace
}  // namespace rotatebook::render
