#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/text.h"
#include "scene/key_rows.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

const char* const kAlone = "[initial]\nangular_velocity = [5, 3, 1]\n";

const char* const kPanels =
    "[initial]\nangular_velocity = [5, 3, 1]\n"
    "[[panel]]\nlabel = \"a\"\nsimulation.model = \"particles\"\n"
    "[[panel]]\nlabel = \"b\"\nexpect.half_turns = [{ min = 1 }, { max = 9, from = 1 }]\n";

/// Values as --set takes them that some key, or the reader of some type, could trip over.
std::vector<std::string> hostileValues() {
  std::vector<std::string> values{
      // Numbers at and beyond the ends of their types
      "0", "-0", "-0.0", "1", "-1", "2", "3", "0.5", "1e-30", "4.9e-324", "-4.9e-324", "1e-400",
      "1e-101", "1e100", "1e308", "-1e308", "1e309", "1.7976931348623157e308", "nan", "-nan", "inf",
      "-inf", "2147483647", "2147483648", "-2147483649", "9223372036854775807",
      "-9223372036854775808", "9223372036854775808", "0x7fffffffffffffff", "0b1", "0o7", "1_0",
      // Other types, dates and times
      "true", "false", "1979-05-27", "1979-05-27T07:32:00Z", "1979-05-27T07:32:00.999999-07:00",
      "07:32:00", "9999-99-99",
      // Strings: empty, long, escaped, with control characters, not UTF-8
      "", "\"\"", "'x'", "\"exact\"", "\"builtin\"", "\"../../etc/passwd\"", "\"/dev/zero\"",
      "\"1e308 deg\"", "\"-1e-308 mm\"", "\"1e999999999999 in\"", "\"0 g\"", "\"1 ms\"", "\"1/0\"",
      "\"99999999999999999999/1001\"", "\"\\u0000\"", "\"a\\nb\\tc\"", "\"\\u001b[2J\"",
      "\"\\u009b2K\"", "\"\\u202Ex\"", "\"\\u2028\"", "\"\\U0010FFFF\"", "\"\\ud800\"", "\"%s%n\"",
      "\"unclosed", "a\nb = 1", "\x1b[2J", "\xff", "\"\xc0\xaf\"",
      // Arrays and tables: empty, nested, of the wrong length
      "[]", "[[]]", "[0]", "[0, 0]", "[0, 0, 0]", "[1, 2, 3]", "[1e308, 1e308, 1e308]",
      "[1e-101, 2e-100, 2e-101]", "[nan, 0, 0]", "[inf, 'z']", "['1 deg', 'z']", "[1, 'z']",
      "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]", "[[1, 2, 3], [4, 5, 6], [7, 8, 9]]", "[64, 36]",
      "[16384, 16384]", "['caption', 'caption']", "['rk4']", "{}", "{ min = 1, max = 0 }",
      "{ min = nan }", "{ rk4 = { min = 1 } }", "[{ min = 1 }, { min = 2, to = 0.5 }]",
      "{ a.b.c.d.e.f.g.h.i = 1 }"};
  values.push_back("\"" + std::string(2000, 'x') + "\"");
  values.push_back("\"" + std::string(40'000, 'x') + "\"");
  values.push_back(std::string(300, '[') + std::string(300, ']'));
  values.push_back("[" + joined(std::vector<std::string>(2000, "1")) + "]");
  return values;
}

/// Returns the key of each row, those of panels once for the first panel.
std::vector<std::string> keysOf(bool ofPanels) {
  std::vector<std::string> keys;
  for (const KeyRow& row : allKeys()) {
    const std::string& name = row.name;
    const bool ofMotion = name.starts_with("body.") || name.starts_with("simulation.") ||
                          name.starts_with("initial.") || name.starts_with("expect.");
    if (!name.starts_with("panel.")) keys.push_back(name);
    if (ofPanels && ofMotion) keys.push_back("panel.0." + name);
    if (ofPanels && name.starts_with("panel.")) keys.push_back("panel.0." + name.substr(8));
  }
  for (const char* section : {"initial", "clip", "panel", "panel.0", "study", "study.orders.rk4"}) {
    keys.push_back(section);
  }
  return keys;
}

/// Requires that `text` with that override is a scene that reads back from its own text, or is
/// refused in whole lines that are safe to print. Returns whether it is a scene.
bool survives(const std::string& text, const std::string& override) {
  const std::vector<std::string> overrides{override};
  try {
    const Scene scene = parseScene(text, "a.toml", overrides);
    const std::string printed = sceneText(scene);
    Scene again = parseScene(printed, "a.toml");
    again.camera.position = scene.camera.position;
    // With panels, the scene's own motion is only where theirs came from.
    if (scene.hasPanels()) again.motion = scene.motion;
    EXPECT_TRUE(again == scene) << oneLine(override, 200) << "\n" << printed;
    return true;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(messageText(message), message);
    EXPECT_TRUE(message.starts_with("--set ") || message.starts_with("a.toml:")) << message;
    EXPECT_LT(message.size(), 5000u) << message;
    return false;
  }
}

// 12,103 overrides; measured 2 to 3 s on two busy cores.
TEST(HostileValues, MakeAWholeSceneOrAPlainRefusal) {
  int scenes = 0, refusals = 0;
  for (const bool ofPanels : {false, true}) {
    for (const std::string& key : keysOf(ofPanels)) {
      for (const std::string& value : hostileValues()) {
        const std::string override = key + "=" + value;
        SCOPED_TRACE(oneLine(override, 100));
        ++(survives(ofPanels ? kPanels : kAlone, override) ? scenes : refusals);
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(scenes, 100);
  EXPECT_GT(refusals, 1000);
  RecordProperty("scenes", scenes);
  RecordProperty("refusals", refusals);
}

}  // namespace
}  // namespace rotatebook::scene
