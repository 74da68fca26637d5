#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/info_report.h"

namespace rotatebook::cli {
namespace {

using scene::BodyNumbers;
using scene::BodySurface;
using ::testing::HasSubstr;

/// A body whose axes of the largest, smallest and middle moment are x, y and z.
BodyNumbers body() {
  BodyNumbers numbers{{0.5, 2, {1, 1e-20, -3}}, BodySurface{12, 1}};
  numbers.properties.inertia = Eigen::Vector3d(4, 2, 3).asDiagonal();
  numbers.properties.inertia(0, 1) = numbers.properties.inertia(1, 0) = 1e-18;
  return numbers;
}

std::string printed(const BodyNumbers& numbers) {
  std::ostringstream output;
  printRows(rowsOn(numbers), output);
  return output.str();
}

TEST(BodyReport, SaysWhatTheBodyIs) {
  EXPECT_EQ(printed(body()),
            "  body        12 triangles, one closed surface\n"
            "  volume      0.5 m^3\n"
            "  mass        2 kg\n"
            "  centre      (1, 0, -3) m\n"
            "  inertia     about the centre [kg m^2]\n"
            "              (4, 0, 0)\n"
            "              (0, 2, 0)\n"
            "              (0, 0, 3)\n"
            "  moments     2 kg m^2 about y, 3 about z, 4 about x\n"
            "  middle axis a spin of w about it is unstable: deviations grow as e^(0.3536 w t)\n");
}

TEST(BodyReport, SaysWhatCountsTwice) {
  BodyNumbers two = body();
  two.surface->shells = 2;
  EXPECT_THAT(printed(two), HasSubstr("2 closed surfaces, which add up: also where they overlap;"));
}

TEST(BodyReport, KnowsABodyThatNeverTumbles) {
  BodyNumbers disc = body();
  disc.properties.inertia = Eigen::Vector3d(1, 1, 2).asDiagonal();
  disc.surface.reset();
  EXPECT_THAT(printed(disc), HasSubstr("no spin is unstable"));
  EXPECT_THAT(printed(disc), HasSubstr("  body        the book, a cuboid\n"));
}

TEST(BodyReport, HasTheSameAsJson) {
  BodyNumbers numbers = body();
  numbers.properties.inertia = Eigen::Vector3d(4, 2, 3).asDiagonal();
  EXPECT_EQ(jsonText(jsonOf(rowsOn(numbers))),
            R"({"volume_m3":0.5,"mass_kg":2.0,"centre_m":[1.0,1e-20,-3.0],)"
            R"("inertia_kg_m2":[[4.0,0.0,0.0],[0.0,2.0,0.0],[0.0,0.0,3.0]],)"
            R"("moments_kg_m2":[2.0,3.0,4.0],)"
            R"("axes":[[0.0,1.0,0.0],[0.0,0.0,1.0],[1.0,0.0,0.0]],)"
            R"("triangles":12,"shells":1,"crossing":null,"overlap":null,"notes":[],)"
            R"("closed":true})");
  numbers.surface.reset();
  EXPECT_THAT(jsonText(jsonOf(rowsOn(numbers))),
              HasSubstr(R"("triangles":null,"shells":null,"crossing":null)"));
}

TEST(BodyReport, NamesAxesThatArentTheBodysByTheirComponents) {
  BodyNumbers numbers = body();
  numbers.properties.inertia << 3, 1, 0, 1, 3, 0, 0, 0, 5;
  EXPECT_THAT(printed(numbers),
              HasSubstr("moments     2 kg m^2 about (0.7071, -0.7071, 0), 4 about "
                        "(0.7071, 0.7071, 0), 5 about z\n"));
}

TEST(BodyReport, NamesTrianglesThatCross) {
  BodyNumbers numbers = body();
  numbers.surface->crossing = {4, 11};
  EXPECT_THAT(printed(numbers),
              HasSubstr("one closed surface\n  note        triangles 5 and 12 cross each other"));
  EXPECT_THAT(jsonText(jsonOf(rowsOn(numbers))), HasSubstr(R"("crossing":[5,12],)"));
}

TEST(BodyReport, HasItsNotes) {
  BodyNumbers numbers = body();
  numbers.surface->overlap = {4, 11};
  numbers.surface->notes = {"a", "\"b\""};
  EXPECT_THAT(
      printed(numbers),
      HasSubstr("one closed surface\n  note        a\n  note        \"b\"\n"
                "  note        triangles 5 and 12 meet at an edge around which something is "
                "enclosed twice"));
  EXPECT_THAT(jsonText(jsonOf(rowsOn(numbers))),
              HasSubstr(R"("overlap":[5,12],"notes":["a","\"b\""],)"));
}

}  // namespace
}  // namespace rotatebook::cli
