// A motion that a program makes, as an MP4: put your own simulation in the place of this one. It is
// drawn by the program rotatebook, which is installed beside the package; the outline is the exact
// motion from the same start.
#include <cstdlib>
#include <fstream>
#include <vector>

#include "physics/simulate.h"

int main() {
  using namespace rotatebook;
  physics::MotionSettings book;
  book.initial.value = {5, 0.05, 0};  // rad/s
  std::vector<double> times;          // five seconds [s]
  for (int frame = 0; frame <= 300; ++frame) times.push_back(frame / 60.0);

  std::ofstream table("recorded.csv");
  table.precision(17);  // so that all bits are read again
  table << "t (s),qw,qx,qy,qz,wx (rad/s),wy (rad/s),wz (rad/s)\n";
  for (const physics::Sample& sample : physics::simulate(book, times).samples) {
    const auto& [q, w] = std::pair(sample.attitude, sample.angularVelocity);
    table << sample.time << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
          << w.x() << ',' << w.y() << ',' << w.z() << '\n';
  }
  table.close();

  std::ofstream("motion.toml") << R"(title = "A motion of my own"
[simulation]
model = "recorded"
file = "recorded.csv"
[clip]
duration = 5
[overlay]
show = ["caption", "ghost"]
)";
  return std::system("rotatebook render motion.toml -o motion.mp4 --no-png") == 0 ? 0 : 1;
}
