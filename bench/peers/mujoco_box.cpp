// A textured box that tumbles about its middle axis, simulated and drawn by MuJoCo without a
// display, 1280x720, 4x multisampled, and piped to ffmpeg; no PNGs.
//   mujoco_box COVER.png OUTPUT.mp4 [FRAMES]
// Prints frames, seconds and processor seconds, ffmpeg's included.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mujoco/mujoco.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kRate = 60;

// Half sides as MuJoCo has them; 20 steps a frame.
constexpr const char* kModel = R"(<mujoco>
  <option gravity="0 0 0" timestep="0.000833333333" integrator="RK4"/>
  <visual>
    <global offwidth="1280" offheight="720"/>
    <quality offsamples="4"/>
  </visual>
  <asset>
    <texture name="cover" type="2d" file="COVER"/>
    <material name="cover" texture="cover"/>
  </asset>
  <worldbody>
    <light pos="0.3 0.5 2" dir="-0.1 -0.2 -1" castshadow="false"/>
    <camera name="front" pos="0 0 0.72" fovy="30"/>
    <body>
      <freejoint/>
      <geom type="box" size="0.0939 0.145425 0.025" mass="1" material="cover"/>
    </body>
  </worldbody>
</mujoco>)";

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, Deleter>;
using Data = std::unique_ptr<mjData, Deleter>;

void require(bool fine, const std::string& what) {
  if (!fine) throw std::runtime_error(what);
}

/// Of the first device that has one, as MuJoCo's own Python binding does it.
EGLDisplay firstDisplay() {
  const auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  require(queryDevices != nullptr && platformDisplay != nullptr, "EGL can't list its devices");
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count);
  for (EGLint i = 0; i < count; ++i) {
    const EGLDisplay display = platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices.at(i), nullptr);
    if (eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  }
  throw std::runtime_error("no EGL display");
}

void makeContextCurrent() {
  constexpr std::array<EGLint, 13> kConfig{EGL_RED_SIZE,
                                           8,
                                           EGL_GREEN_SIZE,
                                           8,
                                           EGL_BLUE_SIZE,
                                           8,
                                           EGL_DEPTH_SIZE,
                                           24,
                                           EGL_SURFACE_TYPE,
                                           EGL_PBUFFER_BIT,
                                           EGL_RENDERABLE_TYPE,
                                           EGL_OPENGL_BIT,
                                           EGL_NONE};
  const EGLDisplay display = firstDisplay();
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, kConfig.data(), &config, 1, &count);
  require(count > 0, "no EGL configuration");
  require(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "EGL has no OpenGL");
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  require(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE,
          "no OpenGL context");
}

Model loadModel(const std::string& coverPath) {
  std::string text = kModel;
  text.replace(text.find("COVER"), 5, coverPath);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  require(mj_makeEmptyFileVFS(files.get(), "box.xml", static_cast<int>(text.size())) == 0,
          "no room for the model");
  text.copy(static_cast<char*>(files->filedata[0]), text.size());
  std::array<char, 500> error{};
  Model model(mj_loadXML("box.xml", files.get(), error.data(), error.size()));
  mj_deleteVFS(files.get());
  require(model != nullptr, error.data());
  return model;
}

/// Handles that MuJoCo draws with.
struct Scene {
  explicit Scene(const mjModel& model) {
    mjv_defaultCamera(&camera);
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = 0;
    mjv_defaultOption(&option);
    mjv_defaultScene(&scene);
    mjr_defaultContext(&context);
    mjv_makeScene(&model, &scene, 100);
    mjr_makeContext(&model, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    require(context.currentBuffer == mjFB_OFFSCREEN, "MuJoCo can't draw off the screen");
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    mjv_freeScene(&scene);
    mjr_freeContext(&context);
  }

  /// RGB, bottom row first.
  void draw(const mjModel& model, mjData& data, std::vector<unsigned char>& picture) {
    const mjrRect whole{0, 0, kWidth, kHeight};
    mjv_updateScene(&model, &data, &option, nullptr, &camera, mjCAT_ALL, &scene);
    mjr_render(whole, &scene, &context);
    mjr_readPixels(picture.data(), nullptr, whole, &context);
  }

  mjvCamera camera{};
  mjvOption option{};
  mjvScene scene{};
  mjrContext context{};
};

void render(const std::string& output, int frames, const std::string& coverPath) {
  makeContextCurrent();
  const Model model = loadModel(coverPath);
  const Data data(mj_makeData(model.get()));
  data->qvel[3] = 4;  // [rad/s]
  data->qvel[5] = 0.0012;
  Scene scene(*model);
  const std::string command =
      "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s 1280x720 -framerate " +
      std::to_string(kRate) +
      " -i - -vf vflip -c:v libx264 -preset veryfast -crf 18 -pix_fmt yuv420p '" + output + "'";
  FILE* ffmpeg = popen(command.c_str(), "w");
  require(ffmpeg != nullptr, "ffmpeg doesn't start");
  std::vector<unsigned char> picture(std::size_t{3} * kWidth * kHeight);
  for (int frame = 0; frame < frames; ++frame) {
    scene.draw(*model, *data, picture);
    if (fwrite(picture.data(), 1, picture.size(), ffmpeg) != picture.size()) break;
    for (int step = 0; step < 20; ++step) mj_step(model.get(), data.get());
  }
  require(pclose(ffmpeg) == 0, "ffmpeg failed");
}

double processorSeconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: mujoco_box COVER.png OUTPUT.mp4 [FRAMES]\n");
    return 2;
  }
  const int frames = argc > 3 ? std::atoi(argv[3]) : 300;
  const auto start = std::chrono::steady_clock::now();
  try {
    render(argv[2], frames, argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mujoco_box: %s\n", error.what());
    return 3;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%d frames, %.2f s, %.2f s of processor time\n", frames, seconds.count(),
              processorSeconds(RUSAGE_SELF) + processorSeconds(RUSAGE_CHILDREN));
}
