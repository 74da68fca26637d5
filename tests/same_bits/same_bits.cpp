// The motions of all scenes that ship, bit by bit, beside a table of what they ought to be:
//     same_bits TABLE SCENES
// prints a row for each scene, with the checksums of its motions, of their tables, and of the
// tables of its study if it has one, and a row for the elementary functions; exits with 1 if the
// table has other rows. What is printed is the new table.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/checksum.h"
#include "base/elementary.h"
#include "scene/scene_text.h"
#include "study/study.h"
#include "study/study_csv.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

scene::Scene readScene(const fs::path& file) {
  return scene::parseScene(textOf(file), file, {}, [&](const fs::path& named, std::size_t) {
    return textOf(file.parent_path() / named);
  });
}

// A blank and the checksum of the study's tables, empty where the scene has none.
std::string studyChecksum(const scene::Scene& scene) {
  if (!scene.study) return "";
  return " " + checksumOf(studyCsv(study::runStudy(scene, {}).value(), *scene.study));
}

std::string rowOf(const fs::path& file) {
  const scene::Scene scene = readScene(file);
  const timeline::ClipMotion motion = timeline::simulateScene(scene, nullptr);
  std::string tables;
  for (const auto& trajectory : motion.trajectories())
    tables += timeline::trajectoryCsv(trajectory);
  return file.stem().string() + " " + timeline::motionChecksum(motion) + " " + checksumOf(tables) +
         studyChecksum(scene);
}

// 65,536 results of each function.
std::string elementaryRow() {
  std::mt19937_64 bits{1};
  std::string bytes;
  const auto add = [&bytes](double number) {
    const auto value = std::bit_cast<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
  };
  for (int i = 0; i < 65'536; ++i) {
    const double x = static_cast<double>(bits() >> 11) * 0x1p-49 - 8;  // in [-8, 8)
    const double y = static_cast<double>(bits() >> 11) * 0x1p-49 - 8;
    for (const double result : {sine(x), cosine(1e4 * y), arcTangent(x), arcTangent(y, x),
                                exponential(80 * x), logarithm(x * x), hyperbolicTangent(x),
                                inverseHyperbolicSine(y), roundedHypotenuse(x, y)}) {
      add(result);
    }
  }
  return "elementary-functions " + checksumOf(bytes);
}

std::vector<std::string> rowsOf(const fs::path& scenes) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  }
  std::vector<std::string> rows{elementaryRow()};
  for (const fs::path& file : files) rows.push_back(rowOf(file));
  return rows;
}

std::vector<std::string> linesOf(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

int compare(const fs::path& table, const fs::path& scenes) {
  const std::vector<std::string> expected = linesOf(table), rows = rowsOf(scenes);
  int wrong = 0;
  for (const std::string& row : rows) {
    std::cout << row << '\n';
    if (std::ranges::count(expected, row) == 1) continue;
    std::cerr << "not in " << table.string() << ": " << row << '\n';
    ++wrong;
  }
  if (expected.size() != rows.size()) {
    std::cerr << table.string() << " has " << expected.size() << " rows, not " << rows.size()
              << '\n';
    ++wrong;
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace rotatebook

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "same_bits TABLE SCENES\n";
    return 2;
  }
  try {
    return rotatebook::compare(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
