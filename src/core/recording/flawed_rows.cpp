#include "recording/flawed_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/number_text.h"
#include "base/text.h"
#include "recording/gyroscope.h"
#include "recording/inertial_recording.h"

namespace rotatebook::recording {
namespace {

using Moments = std::vector<RecordedMoment>;

constexpr double kLargestStep = 0.7;  // usual turn from row to row [rad]

double middleOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Eigen::Vector3d turnAfter(const Moments& moments, std::size_t index) {
  return turnOf(moments[index].attitude.conjugate() * moments[index + 1].attitude);
}

double usualTurn(const Moments& moments) {
  std::vector<double> turns;
  for (std::size_t i = 0; i + 1 < moments.size(); ++i)
    turns.push_back(turnAfter(moments, i).norm());
  return middleOf(std::move(turns));
}

/// Rows in a run that repeat the attitude of the first: from `first` on, up to `end`.
struct Run {
  std::size_t first, end;
};

/// Returns the runs of repeated attitudes of a body that isn't at rest.
std::vector<Run> runsIn(const Moments& moments, bool areRatesGiven) {
  std::vector<Run> runs;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const bool isSame = moments[i].attitude.coeffs() == moments[i - 1].attitude.coeffs();
    const bool isAtRest = areRatesGiven && moments[i].angularVelocity.isZero(0);
    if (!isSame || isAtRest) continue;
    if (!runs.empty() && runs.back().end == i) {
      ++runs.back().end;
    } else {
      runs.push_back({i, i + 1});
    }
  }
  return runs;
}

/// Returns the moments whose attitude isn't that of the one before.
Moments distinctOf(const Moments& moments) {
  Moments distinct{moments.front()};
  for (const RecordedMoment& moment : moments) {
    if (moment.attitude.coeffs() != distinct.back().attitude.coeffs()) distinct.push_back(moment);
  }
  return distinct;
}

/// Returns the rows that are held. Those at an end may be a rest, unless they are no more than
/// elsewhere.
std::vector<std::size_t> heldIn(const Moments& moments, bool areRatesGiven) {
  // A slow turn that is rounded to three decimals makes steps of 1e-3 rad, or none.
  constexpr double kLeastTurn = 2e-3;
  const std::vector<Run> runs = runsIn(moments, areRatesGiven);
  if (runs.empty() || usualTurn(distinctOf(moments)) < kLeastTurn) return {};
  const auto isInside = [&](const Run& run) { return run.first > 1 && run.end < moments.size(); };
  std::size_t longest = 0;
  for (const Run& run : runs) {
    if (isInside(run)) longest = std::max(longest, run.end - run.first);
  }
  std::vector<std::size_t> held;
  for (const Run& run : runs) {
    if (!isInside(run) && run.end - run.first > longest) continue;
    for (std::size_t i = run.first; i < run.end; ++i) held.push_back(i);
  }
  return held;
}

/// The rows that are looked at, by their indices.
using Rows = std::vector<std::size_t>;

/// Neighbouring places among the rows.
struct Places {
  std::size_t first, count;

  bool has(std::size_t place) const { return place >= first && place - first < count; }
};

/// Returns four rows around place `at`, as even as they are, without it and without `leftOut`.
std::array<std::size_t, 4> neighboursOf(const Rows& rows, std::size_t at, const Places& leftOut) {
  std::array<std::size_t, 4> found{};
  std::size_t count = 0, below = at, above = at + 1;
  while (count < found.size()) {
    const bool takesBelow = below > 0 && (count % 2 == 0 || above >= rows.size());
    if (!takesBelow && above >= rows.size()) break;
    const std::size_t place = takesBelow ? --below : above++;
    if (!leftOut.has(place)) found[count++] = rows[place];
  }
  return found;
}

/// Returns the value at `time` of the cubic through four rows.
template <typename ValueOf>
Eigen::Vector3d cubicAt(double time, const Moments& moments, const std::array<std::size_t, 4>& rows,
                        const ValueOf& valueOf) {
  return polynomialAt(
      time, Stencil{0, rows.size()}, [&](std::size_t k) { return moments[rows[k]].time; },
      [&](std::size_t k) { return valueOf(moments[rows[k]]); });
}

double attitudeOff(const Moments& moments, std::size_t row,
                   const std::array<std::size_t, 4>& neighbours) {
  const Eigen::Quaterniond from = moments[neighbours.front()].attitude.conjugate();
  const Eigen::Vector3d turn =
      cubicAt(moments[row].time, moments, neighbours,
              [&](const RecordedMoment& other) { return turnOf(from * other.attitude); });
  return turnOf(rotationBy(turn).conjugate() * from * moments[row].attitude).norm();
}

double ratesOff(const Moments& moments, std::size_t row,
                const std::array<std::size_t, 4>& neighbours) {
  const Eigen::Vector3d rate =
      cubicAt(moments[row].time, moments, neighbours,
              [](const RecordedMoment& other) { return other.angularVelocity; });
  return (moments[row].angularVelocity - rate).norm();
}

/// Deviations of rows from the cubics through their neighbours.
struct Deviations {
  const Moments& moments;
  const Rows& rows;
  bool areOfAttitudes;

  double at(std::size_t place, const Places& leftOut) const {
    const auto neighbours = neighboursOf(rows, place, leftOut);
    return areOfAttitudes ? attitudeOff(moments, rows[place], neighbours)
                          : ratesOff(moments, rows[place], neighbours);
  }

  /// Returns whether the rows beside these fit much better without them, which are off by as much.
  bool fitWithout(const Places& strays, double off) const {
    constexpr double kMuchBetter = 4;
    const std::size_t first = strays.first, end = strays.first + strays.count;
    return (first == 0 || at(first - 1, strays) * kMuchBetter < off) &&
           (end == rows.size() || at(end, strays) * kMuchBetter < off);
  }

  /// Returns by how much those of the places that is off by least is off without the others.
  double leastOff(const Places& places) const {
    double least = at(places.first, places);
    for (std::size_t i = 1; i < places.count; ++i)
      least = std::min(least, at(places.first + i, places));
    return least;
  }
};

/// Returns how many rows from `first` on are stray, up to three: as few as the others fit without.
std::size_t straysFrom(const Deviations& deviations, std::size_t first, double bound) {
  constexpr std::size_t kMost = 3;
  for (std::size_t count = 1; count <= kMost; ++count) {
    if (first + count > deviations.rows.size()) return 0;
    const Places places{first, count};
    const double off = deviations.leastOff(places);
    if (off > bound && deviations.fitWithout(places, off)) return count;
  }
  return 0;
}

/// Returns the stray rows, and the deviation that half of the rows are below.
std::pair<std::vector<StrayRow>, double> straysIn(const Deviations& deviations, double least) {
  constexpr double kFar = 12;
  constexpr std::size_t kMinRows = 8, kMost = 20;  // one of so many
  const std::size_t count = deviations.rows.size();
  if (count < kMinRows) return {};
  std::vector<double> off;
  for (std::size_t place = 0; place < count; ++place)
    off.push_back(deviations.at(place, {place, 1}));
  const double usual = middleOf(off), bound = std::max(kFar * usual, least);
  std::vector<StrayRow> strays;
  for (std::size_t place = 0; place < count; ++place) {
    const std::size_t found = off[place] > bound ? straysFrom(deviations, place, bound) : 0;
    for (std::size_t i = place; i < place + found; ++i) {
      strays.push_back(
          {deviations.rows[i], deviations.areOfAttitudes, deviations.at(i, {place, found})});
    }
    if (found > 0) place += found - 1;
  }
  if (strays.size() > 1 + count / kMost) strays.clear();
  return {strays, usual};
}

/// Returns the number of rows that are missing in the gap after place `at`; 0 without.
int missingAfter(const Moments& moments, const Rows& rows, std::size_t at, double noise) {
  const auto spinAfter = [&](std::size_t place) -> Eigen::Vector3d {
    const RecordedMoment &here = moments[rows[place]], &next = moments[rows[place + 1]];
    return turnOf(here.attitude.conjugate() * next.attitude) / (next.time - here.time);
  };
  constexpr double kMost = 20, kAlike = 0.3, kWhole = 0.15, kSameWay = 0.95, kNoise = 6,
                   kLargestTurn = 2.5;
  const Eigen::Vector3d before = spinAfter(at - 1), here = spinAfter(at), after = spinAfter(at + 1);
  const Eigen::Vector3d usual = (before + after) / 2;
  const double step = moments[rows[at + 1]].time - moments[rows[at]].time;
  const double speed = usual.norm(), ratio = here.norm() / speed;
  const double multiple = std::round(ratio);
  const bool isMultiple =
      multiple > 1 && multiple <= kMost && std::abs(ratio - multiple) < kWhole * multiple / 2 &&
      (before - after).norm() < kAlike * speed && here.dot(usual) > kSameWay * here.norm() * speed;
  const bool isSure =
      here.norm() * step < kLargestTurn && (multiple - 1) * speed * step > kNoise * noise;
  return isMultiple && isSure ? static_cast<int>(multiple) - 1 : 0;
}

std::vector<DroppedRows> droppedIn(const Moments& moments, const Rows& rows, double noise) {
  std::vector<DroppedRows> dropped;
  for (std::size_t at = 1; at + 2 < rows.size(); ++at) {
    if (const int count = missingAfter(moments, rows, at, noise); count > 0)
      dropped.push_back({rows[at], count});
  }
  constexpr std::size_t kMost = 10;  // one of so many
  if (dropped.size() > 1 + rows.size() / kMost) dropped.clear();
  return dropped;
}

/// Adds a list of at most three of the texts to `text`.
std::string withFirst(const std::string& text, const std::vector<std::string>& texts) {
  constexpr std::size_t kShown = 3;
  const std::size_t shown = std::min(kShown, texts.size());
  const std::vector<std::string> first(texts.begin(),
                                       texts.begin() + static_cast<std::ptrdiff_t>(shown));
  return text + joined(first, "; ") +
         (shown < texts.size() ? " and " + std::to_string(texts.size() - shown) + " more" : "");
}

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
  return count == 1 ? "1 " + one : std::to_string(count) + " " + several;
}

std::string strayText(const StrayRow& stray, const std::string& time) {
  constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
  return stray.isAttitude ? "the attitude at " + time + ", by " +
                                roundedText(stray.off * kDegreesPerRadian, 3) + " degrees"
                          : "the rates at " + time + ", by " + roundedText(stray.off, 3) + " rad/s";
}

}  // namespace

double Flaws::largestTurn() const {
  double largest = 0;
  for (const StrayRow& row : stray) {
    if (row.isAttitude) largest = std::max(largest, row.off);
  }
  return largest;
}

Flaws flawsIn(const std::vector<RecordedMoment>& moments, SpinSource source) {
  constexpr double kLeastTurn = 2e-3, kLeastSpin = 0.02;  // [rad], of the usual spin
  const bool haveAttitudes = source != SpinSource::Gyroscope;
  Flaws flaws;
  if (haveAttitudes) flaws.held = heldIn(moments, source == SpinSource::Given);
  Rows rows;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (!std::binary_search(flaws.held.begin(), flaws.held.end(), i)) rows.push_back(i);
  }
  Moments left;
  for (const std::size_t row : rows) left.push_back(moments[row]);
  if (usualTurn(left) > kLargestStep) return flaws;
  const auto leaveOut = [&](const std::vector<StrayRow>& strays) {
    flaws.stray.insert(flaws.stray.end(), strays.begin(), strays.end());
    for (const StrayRow& stray : strays) std::erase(rows, stray.index);
  };
  double noise = 0;
  if (haveAttitudes) {
    const auto [strays, usual] = straysIn({moments, rows, true}, kLeastTurn);
    noise = usual;
    leaveOut(strays);
  }
  if (source != SpinSource::Slopes) {
    std::vector<double> speeds;
    for (const RecordedMoment& moment : left) speeds.push_back(moment.angularVelocity.norm());
    leaveOut(straysIn({moments, rows, false}, kLeastSpin * middleOf(std::move(speeds))).first);
  }
  if (haveAttitudes) flaws.dropped = droppedIn(moments, rows, noise);
  return flaws;
}

std::vector<std::string> textsOf(const Flaws& flaws, const std::vector<RecordedMoment>& moments,
                                 double zero) {
  const auto timeOf = [&](std::size_t row) {
    return timeText(zero + moments[row].time - moments.front().time) + " s";
  };
  std::vector<std::string> texts, stray, dropped;
  for (const StrayRow& one : flaws.stray) stray.push_back(strayText(one, timeOf(one.index)));
  for (const DroppedRows& one : flaws.dropped)
    dropped.push_back(std::to_string(one.count) + " after " + timeOf(one.after));
  if (!stray.empty()) {
    texts.push_back(withFirst(
        counted(stray.size(), "row is off its neighbours: ", "rows are off their neighbours: "),
        stray));
  }
  if (!flaws.held.empty()) {
    texts.push_back(
        counted(flaws.held.size(), "row repeats", "rows repeat") +
        " the attitude of the row before, as held or coarsely rounded readings do, the first at " +
        timeOf(flaws.held.front()));
  }
  if (!dropped.empty()) {
    texts.push_back(
        withFirst("rows seem dropped, as the body turns by a multiple there: ", dropped));
  }
  return texts;
}

std::vector<RecordedMoment> withoutFlaws(const Flaws& flaws,
                                         const std::vector<RecordedMoment>& moments,
                                         SpinSource source) {
  Moments sound;
  double later = 0;
  auto dropped = flaws.dropped.begin();
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const bool isStray = std::ranges::find(flaws.stray, i, &StrayRow::index) != flaws.stray.end();
    if (isStray || std::binary_search(flaws.held.begin(), flaws.held.end(), i)) continue;
    const bool isAfter = dropped != flaws.dropped.end() && i > dropped->after;
    if (isAfter) later += (dropped++)->count * (moments[i].time - moments[i - 1].time);
    sound.push_back(moments[i]);
    sound.back().time += later;
  }
  if (source == SpinSource::Slopes) differentiateAttitudes(sound);
  if (source != SpinSource::Gyroscope) return sound;
  std::vector<Rate> rates;
  for (const RecordedMoment& moment : sound) rates.push_back({moment.time, moment.angularVelocity});
  return integrateRates(rates);
}

}  // namespace rotatebook::recording
