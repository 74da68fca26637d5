#include "render/gl/shader_program.h"

#include <initializer_list>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "embedded/render.h"
#include "render/device/egl_context.h"

namespace rotatebook::render {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::string_view kVertex =
    "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
constexpr std::string_view kFragment =
    "#version 330 core\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }\n";

std::string messageOf(const ShaderSource& vertex, std::initializer_list<ShaderSource> fragments) {
  const EglContext context;
  try {
    const ShaderProgram program("trial", vertex, fragments);
    return "no error";
  } catch (const MachineError& error) {
    return error.what();
  }
}

TEST(ShaderProgram, TakesShadersThatFit) {
  EXPECT_EQ(messageOf(kVertex, {kFragment}), "no error");
}

TEST(ShaderProgram, TakesTheProgramsOwn) {
  EXPECT_EQ(messageOf({studioScatter(), bodyVertexShader()},
                      {{studioScatter(), studioShine(), coverFragmentShader()},
                       toneCurveFragmentShader()}),
            "no error");
  EXPECT_EQ(messageOf({studioScatter(), bodyVertexShader()},
                      {paperFragmentShader(), toneCurveFragmentShader()}),
            "no error");
  EXPECT_EQ(messageOf(wholePictureVertexShader(), {studioFragmentShader()}), "no error");
  EXPECT_EQ(messageOf(wholePictureVertexShader(), {starsFragmentShader()}), "no error");
}

TEST(ShaderProgram, GivesTheCompilersLog) {
  constexpr std::string_view kWrong =
      "#version 330 core\nout vec4 colour;\nvoid main() { colour = vec4(undeclaredName); }\n";
  EXPECT_THAT(
      messageOf(kVertex, {kWrong}),
      AllOf(StartsWith("can't compile the shader trial.frag: "), HasSubstr("undeclaredName")));
  EXPECT_THAT(
      messageOf("#version 330 core\nvoid main() { missingSemicolon }\n", {kFragment}),
      AllOf(StartsWith("can't compile the shader trial.vert: "), HasSubstr("syntax error")));
}

TEST(ShaderProgram, GivesTheLinkersLog) {
  constexpr std::string_view kTwo =
      "#version 330 core\nout vec2 handedOver;\n"
      "void main() { handedOver = vec2(1.0); gl_Position = vec4(0.0); }\n";
  constexpr std::string_view kThree =
      "#version 330 core\nin vec3 handedOver;\nout vec4 colour;\n"
      "void main() { colour = vec4(handedOver, 1.0); }\n";
  EXPECT_THAT(messageOf(kTwo, {kThree}),
              AllOf(StartsWith("can't link the shaders trial: "), HasSubstr("handedOver")));
}

TEST(ShaderProgram, ReadsNoFurtherThanItsSource) {
  const std::string text = std::string(kFragment) + "this is no shader";
  EXPECT_EQ(messageOf(kVertex, {std::string_view(text).substr(0, kFragment.size())}), "no error");
}

}  // namespace
}  // namespace rotatebook::render
