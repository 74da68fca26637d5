// Reads and prints [map].
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/document/problems.h"
#include "scene/keys/keys.h"
#include "scene/motion_numbers.h"
#include "scene/sections.h"
#include "scene/varied_motion.h"

namespace rotatebook::scene {
namespace {

using physics::Model;

/// An axis and the location of its key.
struct LocatedAxis {
  const Axis& axis;
  std::string location;

  [[noreturn]] void fail(const std::string& problem) const {
    document::failAt(location, axis.key + problem);
  }
};

bool anyIs(const std::vector<Panel>& motions, Model model) {
  return std::ranges::any_of(
      motions, [model](const Panel& panel) { return panel.simulation.model == model; });
}

/// Refuses values that a special axis can't have.
void checkEnds(const ValueReader& table, const Axis& axis) {
  constexpr double kLargestLongitude = 720;
  const auto refuseOutside = [&](double min, double max) {
    if (axis.from < min) table.find("from")->mismatch("at least " + tomlNumber(min));
    if (axis.to > max) table.find("to")->mismatch("at most " + tomlNumber(max));
  };
  switch (axis.kind) {
    case AxisKind::MotionKey:
      return;
    case AxisKind::Time:
      return refuseOutside(0, 1e100);
    case AxisKind::SpinLongitude:
      return refuseOutside(-kLargestLongitude, kLargestLongitude);
    case AxisKind::SpinLatitude:
      return refuseOutside(-90, 90);
    case AxisKind::SmallestMoment:
    case AxisKind::MiddleMoment:
      return refuseOutside(0, 1);
  }
}

/// Refuses keys from which other numbers of the motion follow, which a map doesn't make anew.
void refuseWhatOthersFollowFrom(const LocatedAxis& located, const Panel& motion) {
  const std::string& key = located.axis.key;
  const bool isOfBody = key.starts_with("body.");
  if (isOfBody && !motion.solid.isBook()) {
    located.fail(
        ": the mass and the inertia of this body follow from its shape; [study] and [grid] can "
        "vary it");
  }
  if (isOfBody && motion.particles.system) {
    located.fail(": the places of these particles follow from it; [study] and [grid] can vary it");
  }
  const bool isOfSpin = key.starts_with("initial.angular_");
  if (motion.initial.about && (isOfBody || isOfSpin)) {
    located.fail(": the axis of the spin is stated by its moment; state the spin as three numbers");
  }
}

void checkMotionKey(const LocatedAxis& located, const std::vector<Panel>& motions) {
  const auto& [axis, location] = located;
  for (const Panel& panel : motions) {
    refuseWhatOthersFollowFrom(located, panel);
    for (const double value : {axis.from, axis.to}) {
      // Refuses what takes no number
      const MotionNumber number(panel.motion(), axis.key, value, location);
      physics::MotionSettings motion = panel.motion();
      number.set(motion, value);
    }
  }
  refuseUnused(location, axis.key, modelsOf(motions), "runs");
}

void checkAxis(const LocatedAxis& located, const std::vector<Panel>& motions) {
  const AxisKind kind = located.axis.kind;
  if (kind == AxisKind::MotionKey) return checkMotionKey(located, motions);
  const bool isMoment = kind == AxisKind::SmallestMoment || kind == AxisKind::MiddleMoment;
  if (isMoment && anyIs(motions, Model::Particles))
    located.fail(" is of rigid models; the particles' inertia follows from their positions");
}

void checkTime(const ValueReader& section, const MapSettings& map) {
  if (map.timeAxis() == nullptr) return;
  if (const auto duration = section.find("duration")) {
    duration->fail("map.duration: the axis \"time\" says how long the motions are; leave it out");
  }
  const std::string name(nameOf(map.measure));
  if (rowOf(map.measure).span == MeasureSpan::Motion) {
    section.find("measure")->fail("map.measure = " + tomlString(name) +
                                  " is of a whole motion, so no axis can be the time");
  }
  if (map.moment == MapMoment::Largest) {
    section.find("moment")->fail(
        "map.moment = \"largest\" is of a whole motion, so no axis can be the time");
  }
}

void checkMeasure(const Scene& scene) {
  const MapSettings& map = *scene.map;
  for (const Panel& panel : scene.motions) {
    const std::string reason = reasonForAbsence(map.measure, panel.simulation.model);
    if (reason.empty()) continue;
    document::failAt(
        scene.locations.of({"map.measure"}),
        "map.measure = " + tomlString(nameOf(map.measure)) +
            (panel.label.empty() ? "" : ", but of the panel " + tomlString(panel.label)) + ": " +
            reason);
  }
}

void requirePoint(const ValueReader& value, const MapSettings& map, double x, double y) {
  if (map.x.holds(x) && map.y.holds(y)) return;
  value.fail(value.name() + ": the point [" + tomlNumber(x) + ", " + tomlNumber(y) +
             "] is outside the map; widen its axes, or leave it out");
}

/// Places marks that are stated by moments of inertia.
void placeMark(const ValueReader& value, const MapSettings& map, MapMark& mark) {
  if (!mark.moments) return;
  std::ranges::sort(*mark.moments);
  const double smallest = (*mark.moments)[0] / (*mark.moments)[2];
  const double middle = (*mark.moments)[1] / (*mark.moments)[2];
  const bool isAcross =
      map.x.kind == AxisKind::SmallestMoment && map.y.kind == AxisKind::MiddleMoment;
  const bool isUp = map.y.kind == AxisKind::SmallestMoment && map.x.kind == AxisKind::MiddleMoment;
  if (!isAcross && !isUp) {
    value.find("moments")->fail(value.name() +
                                ".moments needs the axes moments.smallest and moments.middle");
  }
  mark.x = isAcross ? smallest : middle;
  mark.y = isAcross ? middle : smallest;
}

void checkMarks(const ValueReader& section, MapSettings& map) {
  const auto value = section.find("marks");
  if (!value || map.marks.empty()) return;
  std::size_t i = 0;
  for (const ValueReader& table : value->tables("")) {
    MapMark& mark = map.marks[i++];
    placeMark(table, map, mark);
    requirePoint(table, map, mark.x, mark.y);
  }
}

void checkMapExpected(const ValueReader& section, const MapSettings& map,
                      const std::vector<Panel>& motions) {
  if (map.expected.empty()) return;
  std::size_t i = 0;
  for (const ValueReader& table : section.find("expect")->tables("")) {
    const MapExpectation& one = map.expected[i++];
    if (one.at) requirePoint(*table.find("at"), map, (*one.at)[0], (*one.at)[1]);
    const auto isIt = [&](const Panel& panel) { return panel.label == one.panel; };
    if (one.panel && std::ranges::none_of(motions, isIt)) {
      table.find("panel")->fail("the scene has no panel " + tomlString(*one.panel));
    }
  }
}

void checkFilm(const ValueReader& section, const MapSettings& map) {
  if (!map.film) return;
  const ValueReader film = *section.find("film");
  if (!map.colours.from || !map.colours.to) {
    film.fail("map.film needs map.colors with from and to, so that a value keeps its colour");
  }
  if (map.film->x.empty() && map.film->y.empty()) {
    film.fail("map.film needs x or y, the part of an axis that it zooms into");
  }
  const auto check = [&](const char* name, const Axis& axis, const std::vector<double>& ends) {
    if (ends.empty() || (axis.holds(ends[0]) && axis.holds(ends[1]) && ends[0] < ends[1])) return;
    film.find(name)->fail("map.film." + std::string(name) + " is from " + tomlNumber(ends[0]) +
                          " to " + tomlNumber(ends[1]) + "; it must ascend within the axis, from " +
                          tomlNumber(axis.from) + " to " + tomlNumber(axis.to));
  };
  check("x", map.x, map.film->x);
  check("y", map.y, map.film->y);
}

void refuseTilt(const LocatedAxis& located, const std::vector<Panel>& motions) {
  const AxisKind kind = located.axis.kind;
  if (kind != AxisKind::SpinLongitude && kind != AxisKind::SpinLatitude) return;
  if (std::ranges::any_of(motions, [](const Panel& panel) { return !!panel.initial.tilt; }))
    located.fail(
        " is the direction of the spin, which initial.tilt would turn; leave the tilt out");
}

void refuseManyMapRuns(const Scene& scene) {
  const std::size_t panels = scene.motions.size();
  const std::int64_t runs = scene.map->runs() * static_cast<std::int64_t>(panels);
  if (runs <= kMaxMapRuns) return;
  document::failAt(scene.locations.of({"map.size"}),
                   "map.size asks for " + std::to_string(runs) + " runs" +
                       (panels > 1 ? " of all panels" : "") + "; the limit is " +
                       std::to_string(kMaxMapRuns) + ", such as [10000, 10000]");
}

}  // namespace

MapSettings readMap(const ValueReader& section, const std::vector<Panel>& motions) {
  MapSettings map;
  readKeys(section, mapKeys(), map);
  for (const char* key : {"x", "y", "measure"}) {
    if (!section.find(key)) section.fail("[map] needs " + std::string(key));
  }
  if (map.x.key == map.y.key) {
    section.find("y", "key")->fail("map.y.key is map.x.key, too; name another key");
  }
  document::Problems problems;
  problems.note([&] { checkTime(section, map); });
  problems.note([&] { checkMarks(section, map); });
  problems.note([&] { checkFilm(section, map); });
  problems.note([&] { checkEnds(*section.find("x"), map.x); });
  problems.note([&] { checkEnds(*section.find("y"), map.y); });
  problems.note([&] { checkMapExpected(section, map, motions); });
  problems.throwIfAny();
  return map;
}

void checkMap(const Scene& scene) {
  const std::vector<Panel>& motions = scene.motions;
  if (anyIs(motions, Model::Recorded)) {
    document::failAt(
        scene.locations.of({"map"}),
        "[map] varies how motions start, which recorded ones don't take; leave it out, or "
        "choose another model");
  }
  const LocatedAxis axes[] = {{scene.map->x, scene.locations.of({"map.x.key"})},
                              {scene.map->y, scene.locations.of({"map.y.key"})}};
  document::Problems problems;
  problems.note([&] { refuseManyMapRuns(scene); });
  for (const LocatedAxis& axis : axes) problems.note([&] { checkAxis(axis, motions); });
  problems.note([&] { checkMeasure(scene); });
  for (const LocatedAxis& axis : axes) problems.note([&] { refuseTilt(axis, motions); });
  problems.throwIfAny();
}

std::string mapText(const Spec& spec, const Printed& printed) {
  return spec.map ? "\n[map]\n" + linesOf(mapKeys(), *spec.map, printed) : "";
}

}  // namespace rotatebook::scene
