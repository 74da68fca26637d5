// A key of a scene file as data.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "physics/motion_settings.h"

namespace rotatebook::scene {

inline constexpr std::size_t kMaxNudges = 100;  ///< Of one motion.

/// The part of a clip that a key changes. Whatever changes the motion changes the others, too.
enum class Affects {
  Motion,   ///< The motions, or which of them there are.
  Picture,  ///< Drawing and encoding.
  Text,     ///< Words, and what is expected.
};

/// The models whose motions a key changes.
struct KeyModels {
  unsigned bits = 0;  ///< One for each model.

  constexpr bool have(physics::Model model) const { return bits >> static_cast<int>(model) & 1; }
  constexpr KeyModels but(KeyModels others) const { return {bits & ~others.bits}; }
  friend bool operator==(KeyModels, KeyModels) = default;
};

constexpr KeyModels only(physics::Model model) {
  return {1u << static_cast<int>(model)};
}

inline constexpr KeyModels kOfAll{~0u},
    kOfRecorded = only(physics::Model::Recorded), kOfComputed = kOfAll.but(kOfRecorded),
    kOfParticles = only(physics::Model::Particles), kOfRigid = kOfComputed.but(kOfParticles),
    kOfStepwise = kOfComputed.but(only(physics::Model::Exact)),
    kOfRigidSteps = kOfStepwise.but(kOfParticles);

/// The types of TOML values that a key takes.
struct ValueKinds {
  bool text = false, number = false, flag = false, list = false, table = false;
};

inline constexpr ValueKinds kTextKind{.text = true}, kNumberKind{.number = true},
    kNumberOrText{.text = true, .number = true}, kListKind{.list = true}, kTableKind{.table = true};

struct KeyRow;

/// The form of a key's value, with its limits.
struct ValueForm {
  enum class Type {
    Own,  ///< One of its own, which KeyRow::allowed describes.
    Integer,
    Number,
    Vector,  ///< Three numbers.
    Text,
    Choice,  ///< One of `choices`.
  };

  Type type = Type::Own;
  double min = 0, max = 0;  ///< Of each number, in SI units; of a text's characters.
  std::optional<Dimension> dimension{};
  std::string_view expected{};  ///< Of Own, Number and Vector, as in messages: "a number".
  std::span<const std::string_view> choices{};  ///< Of Type::Own: values are lists of them.
  bool hasWholeParts = false;                   ///< Of Type::Own: its numbers are integers.
  ValueKinds kinds{};  ///< Of Type::Own; of others, what they take besides.
  /// Of Type::Own: returns the keys of a table, or of each in a list.
  std::vector<KeyRow> (*members)() = nullptr;
  const ValueForm* elements = nullptr;  ///< Of Type::Own: the form of each value in a list.
  int count = 0;                        ///< Of `elements`; 0 for any number.
  /// Of Type::Text: returns the regular expression of allowed texts.
  std::string (*pattern)() = nullptr;

  bool isWhole() const { return type == Type::Integer || hasWholeParts; }
};

/// A key. Its texts are Markdown.
struct KeyRow {
  std::string name;       ///< With its section: "clip.size"; "nudge.N.at" in an array of tables.
  std::string byDefault;  ///< The value as TOML, or a description of one that depends on others.
  std::string allowed;    ///< The allowed values, as in messages: "a number".
  std::string meaning;    ///< With models and unit.
  std::string value;      ///< The default as TOML; empty if there is none, or it depends on others.
  ValueForm form;
  std::string unit;  ///< Of its numbers: "kg m²"; empty if they have none.
  KeyModels models = kOfAll;
  Affects affects = Affects::Motion;
  bool mayVary = false;  ///< In studies, grids and maps: it settles a single motion.
};

}  // namespace rotatebook::scene
