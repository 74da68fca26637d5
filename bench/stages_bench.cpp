// Frames a second by stage and end to end, for the paper's Figure 5 at 1280x720. Compare the rows
// of one run with each other, not with those of another machine or day.
#include <cstdio>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <benchmark/benchmark.h>

#include "base/error.h"
#include "image/png_file.h"
#include "overlay/marks.h"
#include "overlay/words.h"
#include "physics/trajectory.h"
#include "pipeline/render_clip.h"
#include "pipeline/textures.h"
#include "pipeline/trajectory_csv.h"
#include "scene/scene_file.h"
#include "video/video_writer.h"

namespace rotatebook {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kFrames = 300;

scene::Scene benchScene() {
  return scene::readScene(fs::path(ROTATEBOOK_SCENES) / "figures/fig05-unstable-x.toml");
}

const physics::Trajectory& benchTrajectory() {
  static const physics::Trajectory trajectory = simulate(benchScene().motion(), kFrames);
  return trajectory;
}

fs::path benchFolder() {
  const fs::path folder = fs::temp_directory_path() / "rotatebook-bench";
  fs::create_directories(folder);
  return folder;
}

/// A picture with a book in it.
const image::Image& benchPicture() {
  static const image::Image picture = [] {
    render::Renderer renderer = pipeline::makeRenderer(benchScene());
    image::Image drawn = renderer.makePicture();
    renderer.draw(benchTrajectory().samples[100].corners, drawn);
    return drawn;
  }();
  return picture;
}

void countFrames(benchmark::State& state, std::int64_t framesPerIteration) {
  const auto frames = static_cast<double>(state.iterations() * framesPerIteration);
  state.counters["frames/s"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
}

void simulateAll(benchmark::State& state) {
  const physics::MotionSettings motion = benchScene().motion();
  for (auto _ : state) benchmark::DoNotOptimize(simulate(motion, kFrames));
  countFrames(state, kFrames);
}

void writeTable(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(pipeline::trajectoryCsv(benchTrajectory()));
  countFrames(state, kFrames);
}

void draw(benchmark::State& state) {
  render::Renderer renderer = pipeline::makeRenderer(benchScene());
  image::Image picture = renderer.makePicture();
  std::size_t frame = 0;
  for (auto _ : state) {
    renderer.draw(benchTrajectory().samples[frame++ % kFrames].corners, picture);
  }
  countFrames(state, 1);
  state.SetLabel(renderer.description());
}

/// What is drawn over a picture; `show` as overlay.show has it, the scene's own if it is empty.
void overlays(benchmark::State& state, const std::string& show) {
  scene::Scene scene = benchScene();
  if (!show.empty()) {
    scene = scene::readScene(fs::path(ROTATEBOOK_SCENES) / "figures/fig05-unstable-x.toml",
                             std::vector{"overlay.show=[" + show + "]"});
  }
  overlay::Words words(scene);
  overlay::Marks marks(scene, benchTrajectory(),
                       {scene.clip.width, scene.clip.height, words.corner(), words.bottomRows()});
  const render::Screen screen{scene.clip.width, scene.clip.height, marks.bottomRows()};
  const render::Camera camera = pipeline::cameraOf(scene, screen);
  image::Image picture = benchPicture();
  std::int64_t frame = 0;
  for (auto _ : state) {
    const physics::Sample& sample = benchTrajectory().samples[static_cast<std::size_t>(frame)];
    marks.draw(frame, render::project(camera, sample.corners, screen).clipFromWorld, picture);
    words.draw(frame, picture);
    frame = (frame + 1) % kFrames;
  }
  countFrames(state, 1);
}

void writePng(benchmark::State& state) {
  const fs::path path = benchFolder() / "frame.png";
  benchPicture();  // Drawn before the clock starts.
  for (auto _ : state) image::writePng(path, benchPicture().view());
  countFrames(state, 1);
}

void convertAndEncode(benchmark::State& state) {
  const video::VideoSettings settings = pipeline::videoSettings(benchScene(), "");
  video::VideoWriter writer(video::VideoFormat::Mp4, benchFolder() / "clip.mp4", settings);
  benchPicture();
  for (auto _ : state) writer.write(benchPicture().view());
  writer.finish();
  countFrames(state, 1);
}

void endToEnd(benchmark::State& state) {
  const scene::Scene scene = benchScene();
  pipeline::RenderOptions options;
  options.folder = benchFolder();
  options.png = state.range(0) != 0;
  if (state.range(1) == 0) options.formats.clear();
  for (auto _ : state) {
    const pipeline::ClipMotion motion({simulate(scene.motion(), kFrames)}, scene.clip.frameRate);
    pipeline::renderClip(scene, motion, options, {});
  }
  countFrames(state, kFrames);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

BENCHMARK(simulateAll)->Unit(benchmark::kMillisecond);
BENCHMARK(writeTable)->Unit(benchmark::kMillisecond);
BENCHMARK(draw)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(overlays, scenes_own, "")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, caption, "'caption'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, clock, "'clock'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, axes, "'axes'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, omega, "'omega'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, momentum, "'momentum'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, trail, "'trail'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, polhode, "'polhode'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, energy, "'energy'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, error, "'error'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, half_turns, "'half_turns'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, springs, "'springs'")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(overlays, ghost, "'ghost'")->Unit(benchmark::kMillisecond);
BENCHMARK(writePng)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(convertAndEncode)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(endToEnd)
    ->ArgNames({"png", "mp4"})
    ->Args({1, 0})
    ->Args({0, 1})
    ->Args({1, 1})
    ->Unit(benchmark::kSecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(1);

}  // namespace
}  // namespace rotatebook

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  try {
    benchmark::RunSpecifiedBenchmarks();
  } catch (const rotatebook::Error& error) {
    std::fprintf(stderr, "rotatebook_bench: %s\n", error.what());
    return 3;
  }
  std::error_code ignored;
  std::filesystem::remove_all(std::filesystem::temp_directory_path() / "rotatebook-bench", ignored);
  return 0;
}
