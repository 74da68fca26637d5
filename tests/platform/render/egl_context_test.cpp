#include "render/device/egl_context.h"

#include <cstdlib>
#include <iostream>
#include <latch>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <epoxy/egl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "render/gl/gl_handles.h"

namespace rotatebook::render {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Prints the message of a machine without an EGL driver. Runs in a process of its own.
[[noreturn]] void printWhatIsMissing() {
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
  try {
    const EglContext context;
    std::cerr << "no error: " << context.description();
    std::exit(0);
  } catch (const MachineError& error) {
    std::cerr << error.what();
    std::exit(3);
  }
}

TEST(EglContextDeathTest, NamesEachCandidateAndTheRemedyWithoutADriver) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(printWhatIsMissing(), ::testing::ExitedWithCode(3),
              AllOf(HasSubstr("can't draw: no EGL display gives an OpenGL 3.3 core context:"),
                    HasSubstr("\n  EGL devices: "),
                    HasSubstr("\n  default EGL display: eglGetDisplay: EGL_"),
                    HasSubstr("apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri")));
}

TEST(EglContext, IsCurrentAndOfVersion33OrLater) {
  const EglContext context;
  GLint major = 0, minor = 0, profile = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(EglContext, DescribesRendererVersionAndDisplay) {
  const EglContext context;
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  EXPECT_THAT(context.description(), HasSubstr(renderer + ", OpenGL "));
  EXPECT_THAT(context.description(), HasSubstr("EGL"));
}

TEST(EglContext, CanBeMadeAgain) {
  for (int i = 0; i < 3; ++i) {
    const EglContext context;
    EXPECT_NE(glGetString(GL_VERSION), nullptr);
  }
}

TEST(EglContext, OutlivesThatOfAnotherThread) {
  std::optional<EglContext> first(std::in_place);
  std::latch made(1), firstIsGone(1);
  EGLBoolean known = EGL_FALSE;
  std::thread other([&] {
    const EglContext second;
    made.count_down();
    firstIsGone.wait();
    EGLint api = 0;  // libepoxy asks for it, too, when it looks a function up.
    known = eglQueryContext(eglGetCurrentDisplay(), eglGetCurrentContext(), EGL_CONTEXT_CLIENT_TYPE,
                            &api);
  });
  made.wait();
  first.reset();
  firstIsGone.count_down();
  other.join();
  EXPECT_TRUE(known);
}

}  // namespace
}  // namespace rotatebook::render
