// rotatebook info, which prints the numbers of a scene's body and spin, or of a mesh.
#include <string>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Info : public ProgramTest {
 protected:
  /// Writes a box of 20 x 30 x 60 mm, in millimetres, without its last `missing` sides.
  void writeBox(const std::string& name, std::size_t missing = 0) const {
    std::string obj;
    for (int i = 0; i < 8; ++i) {
      obj += std::string("v ") + ((i & 1) != 0 ? "20 " : "0 ") + ((i & 2) != 0 ? "30 " : "0 ") +
             ((i & 4) != 0 ? "60\n" : "0\n");
    }
    const std::string sides[] = {"1 5 7 3", "2 4 8 6", "1 2 6 5", "3 7 8 4", "1 3 4 2", "5 6 8 7"};
    for (std::size_t i = 0; i + missing < std::size(sides); ++i) obj += "f " + sides[i] + '\n';
    write(name, obj);
  }
  /// Returns the first number of a member's value.
  static double numberAfter(const std::string& json, const std::string& key) {
    return std::stod(json.substr(json.find_first_of("0123456789-", json.find(key) + key.size())));
  }
  void expectRefused(const std::vector<std::string>& words, const std::string& message) const {
    const ChildResult result = run(words);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.error, HasSubstr(message));
  }
};

TEST_F(Info, MeasuresAMesh) {
  writeBox("box.obj");
  const ChildResult result = run({"info", "box.obj", "--unit", "mm", "--density", "2500"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output,
              AllOf(StartsWith("box.obj\n  body        12 triangles, one closed surface\n"),
                    HasSubstr("volume      3.6e-05 m^3\n"), HasSubstr("mass        0.09 kg\n"),
                    HasSubstr("centre      (0.01, 0.015, 0.03) m\n"),
                    HasSubstr("moments     9.75e-06 kg m^2 about z, ")));
  EXPECT_EQ(run({"info", "box.obj", "--unit=mm", "--mass=0.09"}).output, result.output);
  EXPECT_THAT(run({"info", "box.obj", "--unit", "cm"}).output, HasSubstr("mass        36 kg"));
}

TEST_F(Info, MeasuresTheBookOfAScene) {
  const ChildResult result = run({"info", "tiny.toml", "--json", "--set", "body.mass=2"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr(R"("name":"tiny",)"), HasSubstr(R"("mass_kg":2.0,)"),
                                   HasSubstr(R"("triangles":null)")));
}

TEST_F(Info, MeasuresTheShapeOfAScene) {
  write("handle.toml",
        "[body]\nshape = \"t-handle\"\nmass = 0.5\n"
        "[initial]\nangular_velocity = { about = \"middle\", value = 4 }\n");
  const ChildResult result = run({"info", "handle.toml"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("mass        0.5 kg\n"), HasSubstr("(0, 0.01266")));
  EXPECT_THAT(result.output, HasSubstr("body        1024 triangles, 2 closed surfaces"));
  EXPECT_THAT(run({"info", "handle.toml", "--json"}).output,
              HasSubstr(R"("triangles":1024,"shells":2,)"));
  EXPECT_EQ(run({"simulate", "handle.toml"}).status, 0);
  EXPECT_EQ(run({"check", "handle.toml"}).output, "handle.toml: ok\n");
}

TEST_F(Info, MeasuresTheMeshOfAScene) {
  writeBox("box.obj");
  write("box.toml",
        "[body]\nmesh = \"box.obj\"\nunit = \"mm\"\ndensity = 2500\n"
        "[initial]\nangular_velocity = [4, 0, 0]\n");
  EXPECT_THAT(
      run({"info", "box.toml"}).output,
      AllOf(HasSubstr("body        12 triangles, one closed surface\n"),
            HasSubstr("mass        0.09 kg\n"), HasSubstr("centre      (0.01, 0.015, 0.03) m\n")));
  const std::string json = run({"info", "box.toml", "--json"}).output;
  EXPECT_THAT(json, AllOf(HasSubstr(R"("centre_m":[0.01)"),
                          HasSubstr(R"("triangles":12,"shells":1,"crossing":null,)")));
  // The mesh by itself has the same numbers, but for their rounding
  const std::string alone =
      run({"info", "box.obj", "--unit=mm", "--density=2500", "--json"}).output;
  for (const char* key : {"volume_m3", "mass_kg", "centre_m", "moments_kg_m2"})
    EXPECT_NEAR(numberAfter(json, key), numberAfter(alone, key), 1e-12 * numberAfter(alone, key));
  std::filesystem::create_directory(folder() / "below");
  std::filesystem::rename(folder() / "box.toml", folder() / "below/box.toml");
  expectRefused({"info", "below/box.toml", "--set", "body.mesh=../box.obj"},
                "leads outside the scene's folder");
  EXPECT_EQ(
      run({"info", "below/box.toml", "--set", "body.mesh=../box.obj", "--allow-outside"}).status,
      0);
}

TEST_F(Info, MeasuresTheBodyOfEachPanel) {
  write("two.toml",
        "[initial]\nangular_velocity = [4, 0, 0]\n[[panel]]\nlabel = \"book\"\n"
        "[[panel]]\nlabel = \"heavy\"\nbody.mass = 3\n");
  EXPECT_THAT(run({"info", "two.toml"}).output,
              AllOf(HasSubstr("book:\n  body        the book, a cuboid\n"),
                    HasSubstr("heavy:\n  body        the book, a cuboid\n"),
                    HasSubstr("mass        3 kg\n")));
  EXPECT_THAT(run({"info", "two.toml", "--json"}).output,
              AllOf(HasSubstr(R"("motions":[{"label":"book","body":{"volume_m3":)"),
                    HasSubstr(R"("mass_kg":3.0,)")));
}

TEST_F(Info, NotesTrianglesThatCross) {
  write("cross.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
        "v 0.1 0.1 0.1\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
  const ChildResult result = run({"info", "cross.obj"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("cross each other"));
}

// A corner that a triangle writes otherwise by rounding, and a triangle without area.
TEST_F(Info, NotesWhatItChangesOfAMesh) {
  write("near.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1e-17 0 0\n"
        "f 2 2 1\nf 1 3 2\nf 5 2 4\nf 1 4 3\nf 2 3 4\n");
  const ChildResult result = run({"info", "near.obj"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(
      result.output,
      HasSubstr("body        4 triangles, one closed surface\n"
                "  note        one point is taken as another that lies 1e-17 from it; the mesh is "
                "1 long\n"
                "  note        one triangle has a corner twice, and is left out\n"));
  EXPECT_THAT(run({"info", "near.obj", "--json"}).output,
              HasSubstr(R"("notes":["one point is taken)"));
  write("near.toml",
        "[body]\nmesh = \"near.obj\"\ndensity = 1000\n"
        "[initial]\nangular_velocity = [4, 1, 2]\n[clip]\nduration = 0.5\n");
  EXPECT_THAT(run({"info", "near.toml"}).output,
              HasSubstr("note        one point is taken as another"));
  EXPECT_THAT(run({"check", "near.toml"}).error,
              HasSubstr("note: near: near.obj: one point is taken as another that lies 1e-17"));
}

TEST_F(Info, MeasuresBodiesThatTouch) {
  const std::string sides[] = {"1 5 7 3", "2 4 8 6", "1 2 6 5", "3 7 8 4", "1 3 4 2", "5 6 8 7"};
  std::string obj, faces;
  for (int cube = 0; cube < 2; ++cube) {
    for (int i = 0; i < 8; ++i) {
      for (const int bit : {0, 1, 2})
        obj += (bit == 0 ? "v " : " ") + std::to_string((i >> bit & 1) + (bit < 2 ? cube : 0));
      obj += '\n';
    }
    for (const std::string& side : sides) {
      faces += 'f';
      for (const char letter : side)
        faces += letter == ' ' ? "" : " " + std::to_string(letter - '0' + 8 * cube);
      faces += '\n';
    }
  }
  write("touch.obj", obj + faces);
  const ChildResult result = run({"info", "touch.obj"});
  EXPECT_EQ(result.error, "");
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("24 triangles, 2 closed surfaces"), HasSubstr("volume      2 m^3\n"),
                    HasSubstr("centre      (1, 1, 0.5) m\n")));
}

TEST_F(Info, RefusesWhatItCannotMeasure) {
  writeBox("open.obj", 1);
  writeBox("box.obj");
  write("a.glb", "glTF");
  expectRefused({"info", "open.obj"},
                "rotatebook: open.obj: the edge from (0, 0, 60) to (0, 30, 60) belongs to triangle "
                "1 alone: the surface is open there; close the hole\n");
  expectRefused({"info", "box.obj", "--mass", "1e-59"}, "box.obj: ");
  expectRefused({"info", "box.fbx"}, "box.fbx: neither a scene (.toml) nor a mesh");
  expectRefused({"info", "a.glb"}, "rotatebook: a.glb: it doesn't begin with \"glTF\"");
  expectRefused({"info", "no.stl"}, "rotatebook: can't read no.stl: No such file or directory\n");
  expectRefused({"info", "box.obj", "--unit", "ell"}, "there are m, cm, mm, km, in\n");
  expectRefused({"info", "box.obj", "--density", "0"},
                "--density 0: must be above 0, and below 1e60\n");
  expectRefused({"info", "box.obj", "--mass", "1", "--density", "1"}, "name one of them\n");
  expectRefused({"info", "tiny.toml", "--density", "1"}, "tiny.toml has a body of its own\n");
}

}  // namespace
}  // namespace rotatebook::cli::testing
