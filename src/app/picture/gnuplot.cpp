#include "picture/gnuplot.h"

#include <string_view>
#include <unistd.h>

#include "base/error.h"
#include "base/text.h"
#include "system/atomic_file.h"
#include "system/child_process.h"
#include "system/file_descriptor.h"

namespace rotatebook::picture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSvg =
    "set terminal svg size 1200,600 enhanced font 'sans-serif,12' fontscale 1.3 "
    "background rgb 'white'\npoint_size = 0.7\n";
constexpr const char* kPng =
    "set terminal pngcairo size 1800,900 enhanced font 'sans,12' fontscale 1.5 linewidth 1.5 "
    "pointscale 1.5 background rgb 'white'\npoint_size = 1\n";

/// Runs gnuplot; returns its exit status, or 128 + signal if a signal ended it.
int runGnuplot(const system::StandardStreams& streams) {
  // -d ignores the user's own settings.
  auto gnuplot = system::ChildProcess::start({"gnuplot", "-d"}, streams);
  if (!gnuplot) {
    throw MachineError("can't draw the plot: gnuplot isn't installed; apt-get install gnuplot-nox");
  }
  const system::ProcessEnd end = gnuplot->wait();
  return end.signal == 0 ? end.status : 128 + end.signal;
}

/// A file format, and the last bytes of each complete file.
struct Format {
  const char* terminal;
  std::string_view last;
};

/// Returns a picture's bytes; `path` is only for messages. Gnuplot writes to memory because it
/// doesn't report a full disk.
std::string draw(const Format& format, const std::string& commands, const fs::path& path) {
  const system::FileDescriptor input = system::createMemoryFile("plot"),
                               output = system::createMemoryFile("picture"),
                               problems = system::createMemoryFile("problems");
  system::writeAll(input, format.terminal + commands, "a plot");
  lseek(input.number(), 0, SEEK_SET);
  const int status = runGnuplot({input, output, problems});
  std::string picture = system::readAll(output, path);
  if (status == 0 && picture.rfind(format.last) != std::string::npos) return picture;
  std::string message(trimmed(system::readAll(problems, path)));
  if (message.empty() && status == 0) {
    message = "the picture is incomplete; is the file size limited (ulimit -f)?";
  }
  throw MachineError("gnuplot can't draw " + path.string() + " (status " + std::to_string(status) +
                     ")" + (message.empty() ? "" : ": " + message));
}

}  // namespace

void drawPlot(const std::string& commands, const fs::path& svg, const fs::path& png) {
  const std::string vectors = draw({kSvg, "</svg>"}, commands, svg);
  const std::string pixels = draw({kPng, "IEND\xae\x42\x60\x82"}, commands, png);
  system::writeFileAtomically(svg, vectors);
  system::writeFileAtomically(png, pixels);
}

std::string gnuplotString(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) {
    const bool control = static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
    // Doubling a quote would escape it for gnuplot, but not at the start of a string.
    if (letter == '\'') {
      quoted += "’";
    } else {
      quoted += control ? ' ' : letter;
    }
  }
  return quoted + "'";
}

}  // namespace rotatebook::picture
