#include "recording/column_finder.h"

#include <algorithm>

#include "base/text.h"
#include "recording/column_name.h"
#include "recording/column_units.h"
#include "recording/unit_tables.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

using Found = std::vector<std::optional<std::size_t>>;

bool isWhole(const Found& columns) {
  return std::ranges::all_of(columns, [](const auto& one) { return one.has_value(); });
}

/// Returns the indices of columns that are all there.
std::vector<std::size_t> foundIndices(const Found& columns) {
  std::vector<std::size_t> indices;
  for (const auto& one : columns) indices.push_back(one.value());
  return indices;
}

/// Returns the length of a device's name before all names that end as Shimmer's do, such as
/// "S_Head_Gyro_X_CAL"; 0 if there is none.
std::size_t deviceLength(const std::vector<std::string>& header) {
  constexpr std::string_view kEnd = "_CAL";
  constexpr std::size_t kFewest = 4;  // the time and three axes
  std::string_view common;
  std::size_t count = 0;
  for (const std::string& whole : header) {
    const std::string_view name = std::string_view(whole).substr(0, whole.find(" ("));
    if (!name.ends_with(kEnd)) continue;
    if (count++ == 0) common = name;
    common = common.substr(
        0, static_cast<std::size_t>(
               std::mismatch(common.begin(), common.end(), name.begin(), name.end()).first -
               common.begin()));
  }
  return count < kFewest ? 0 : common.rfind('_') + 1;
}

/// Returns whether a column that may be of times is rather of temperatures: another unit's, or "T".
bool isTemperature(std::string_view header) {
  const std::string unit = columnNameOf(header).unit;
  return header == "T" || (!unit.empty() && !unitNamed(kUnitsOfTimes, unit));
}

}  // namespace

ColumnFinder::ColumnFinder(const CsvTable& table, const ColumnNames& named)
    : table_(table), named_(named) {
  const std::size_t device = deviceLength(table.header());
  for (const std::string& name : table.header()) {
    const bool isOfDevice = name.find("_CAL") != name.npos;
    plain_.push_back(columnNameOf(name.substr(isOfDevice ? device : 0)).plain);
  }
}

std::optional<std::size_t> ColumnFinder::time() const {
  if (const auto column = named("time")) return column;
  std::vector<std::size_t> found;  // In the order of preference.
  for (const std::string_view name : wordsOf(kTimeNames)) {
    for (std::size_t i = 0; i < plain_.size(); ++i) {
      if (isTimeNamed(plain_[i], name) && std::ranges::count(found, i) == 0) found.push_back(i);
    }
  }
  const auto dropUnlessAll = [&](const auto& isOther) {
    if (!std::ranges::all_of(found, isOther)) std::erase_if(found, isOther);
  };
  // Clock times as text aren't read, but may stand beside others.
  dropUnlessAll([&](std::size_t column) { return table_.isText(0, column); });
  dropUnlessAll([&](std::size_t column) { return isTemperature(table_.header()[column]); });
  if (found.empty()) return std::nullopt;
  for (std::size_t i = 1; i < found.size(); ++i) {
    const std::string &first = plain_[found.front()], &other = plain_[found[i]];
    if (first == other || !isAmong(kPreferredTimes, first)) failTwice(found.front(), found[i]);
  }
  return found.front();
}

std::optional<std::size_t> ColumnFinder::nanoseconds() const {
  return onlyOne([&](std::size_t i) { return isAmong(kNanosecondNames, plain_[i]); });
}

std::optional<std::array<std::size_t, 3>> ColumnFinder::bareAxes() const {
  if (hasPlain("w")) return std::nullopt;
  std::array<std::size_t, 3> columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string axis(1, static_cast<char>('x' + i));
    const auto column = onlyOne([&](std::size_t k) {
      return plain_[k] == axis || plain_[k] == axis + "axis" || plain_[k] == "axis" + axis;
    });
    if (!column) return std::nullopt;
    columns[i] = *column;
  }
  return columns;
}

bool ColumnFinder::isNamed(const Spellings& group) const {
  return std::ranges::any_of(named_,
                             [&](const auto& one) { return isAmong(group.roles, one.first); });
}

/// Returns whether the options name a column of the group by an empty text.
bool ColumnFinder::isLeftOut(const Spellings& group) const {
  return std::ranges::any_of(named_, [&](const auto& one) {
    return isAmong(group.roles, one.first) && one.second.empty();
  });
}

std::string ColumnFinder::names() const {
  constexpr std::size_t kShown = 12;
  constexpr std::size_t kLongest = 40;  // [characters]
  std::vector<std::string> shown;
  for (const std::string& name : table_.header()) {
    if (shown.size() == kShown) break;
    shown.push_back(quotedBeginning(name, kLongest));
  }
  if (table_.header().size() > kShown) {
    shown.push_back(std::to_string(table_.header().size() - kShown) + " more");
  }
  return listed(shown);
}

void ColumnFinder::failTwice(std::size_t first, std::size_t second) const {
  const std::string &one = table_.header()[first], &other = table_.header()[second];
  const std::string remedy =
      one == other ? "give one of them another name, or put what belongs to it in another table"
                   : "name the one to take in simulation.columns, or with --column";
  table_.fail("the columns " + std::to_string(first + 1) + " and " + std::to_string(second + 1) +
              ", " + quotedText(one) + " and " + quotedText(other) + ", hold the same; " + remedy);
}

std::optional<std::vector<std::size_t>> ColumnFinder::columnsOf(const Spellings& group) const {
  if (isLeftOut(group)) return std::nullopt;
  const Columns stated = named(group);
  if (isWhole(stated)) return foundIndices(stated);
  const std::vector<Whole> wholes = wholesOf(group, stated);
  if (wholes.empty()) return wholeOrNone(group, partOf(group, stated));
  const auto confirmed = std::ranges::find_if(wholes, &Whole::isConfirmed);
  if (confirmed != wholes.end()) return foundIndices(confirmed->columns);
  const Whole& first = wholes.front();
  for (const Whole& other : wholes) {
    if (isAmong(group.preferred, first.beginning)) break;
    for (std::size_t i = 0; i < stated.size(); ++i)
      if (first.columns[i] != other.columns[i]) failTwice(*first.columns[i], *other.columns[i]);
  }
  if (!isNamed(group)) requireSingle(group, first);
  return foundIndices(first.columns);
}

/// Returns the spellings in which the group is whole, with the columns that are stated in place of
/// theirs.
std::vector<ColumnFinder::Whole> ColumnFinder::wholesOf(const Spellings& group,
                                                        const Columns& stated) const {
  std::vector<Whole> wholes;
  for (const std::string_view beginning : wordsOf(group.beginnings)) {
    for (const std::string_view ends : group.ends) {
      if (ends.empty()) continue;
      Whole one{beginning, spelling(beginning, ends, stated)};
      const bool isAny = one.columns != Columns(one.columns.size());
      for (std::size_t i = 0; i < stated.size(); ++i) {
        one.isConfirmed |= stated[i] && one.columns[i] == stated[i];
        if (stated[i]) one.columns[i] = stated[i];
      }
      if (!isAny || !isWhole(one.columns)) continue;
      wholes.push_back(one);
      break;  // "1 2 3" after "0 1 2" is the same array.
    }
  }
  return wholes;
}

/// Returns the indices of a group's columns; nothing if it has none. Throws InputError if some are
/// missing.
std::optional<std::vector<std::size_t>> ColumnFinder::wholeOrNone(const Spellings& group,
                                                                  const Columns& columns) const {
  std::vector<std::string> missing;
  const std::vector<std::string_view> roles = wordsOf(group.roles);
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (!columns[i]) missing.emplace_back(roles[i]);
  if (missing.size() == roles.size()) return std::nullopt;
  if (missing.empty()) return foundIndices(columns);
  table_.fail("no column for " + listed(missing) + " among " + names() +
              "; name it in simulation.columns, or with --column");
}

/// Throws InputError if an axis of the spelling that is taken has a column in another spelling,
/// too, though not all of them have.
void ColumnFinder::requireSingle(const Spellings& group, const Whole& taken) const {
  constexpr std::size_t kAxes = 3;
  const Columns& columns = taken.columns;
  if (columns.size() != kAxes || isAmong(group.preferred, taken.beginning)) return;
  for (const std::string_view beginning : wordsOf(group.beginnings)) {
    const Columns others = spelling(beginning, group.ends.front(), Columns(kAxes));
    for (std::size_t i = 0; i < others.size(); ++i)
      if (others[i] && others[i] != columns[i]) failTwice(*columns[i], *others[i]);
  }
}

/// Returns what there is of a group that isn't whole in any spelling, with what is stated.
ColumnFinder::Columns ColumnFinder::partOf(const Spellings& group, Columns part) const {
  for (const std::string_view beginning : wordsOf(group.beginnings)) {
    // A single letter for a quaternion's part is recognised beside the three others alone.
    if (isAmong(group.loose, beginning) || (beginning.empty() && !hasPlain("w"))) continue;
    const Columns columns = spelling(beginning, group.ends.front(), part);
    for (std::size_t i = 0; i < part.size(); ++i)
      if (!part[i]) part[i] = columns[i];
  }
  return part;
}

/// Returns the columns called so; an axis may come first, as in "X-gyro". Of those that are stated,
/// others of the same name aren't looked at.
ColumnFinder::Columns ColumnFinder::spelling(std::string_view beginning, std::string_view ends,
                                             const Columns& stated) const {
  const bool areAxes = ends == "x y z", areNumbers = ends == "0 1 2" || ends == "1 2 3";
  const bool isShort = beginning.size() <= 2;
  Columns columns(wordsOf(ends).size());
  if (areNumbers && isShort) return columns;  // A0 to A2 are pins.
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string end(wordsOf(ends)[k]);
    const std::string name = std::string(beginning) + end;
    const std::string turned = areAxes && !isShort ? end + std::string(beginning) : name;
    const auto isIt = [&](std::size_t i) { return plain_[i] == name || plain_[i] == turned; };
    if (!stated[k]) columns[k] = onlyOne(isIt);
    if (stated[k] && isIt(*stated[k])) columns[k] = stated[k];
  }
  // "Rot[0]" to "Rot[8]" are no quaternion.
  const bool goesOn = ends == "0 1 2 3" && hasPlain(std::string(beginning) + "4");
  return goesOn ? Columns(columns.size()) : columns;
}

ColumnFinder::Columns ColumnFinder::named(const Spellings& group) const {
  Columns columns;
  for (const std::string_view role : wordsOf(group.roles)) columns.push_back(named(role));
  return columns;
}

std::optional<std::size_t> ColumnFinder::named(std::string_view role) const {
  const auto stated = std::ranges::find_if(
      named_, [role](const auto& one) { return std::string_view(one.first) == role; });
  if (stated == named_.end()) return std::nullopt;
  const std::string& name = stated->second;
  auto found = onlyOne([&](std::size_t i) { return table_.header()[i] == name; });
  // A unit may be from another line.
  if (!found)
    found = onlyOne([&](std::size_t i) { return table_.header()[i].starts_with(name + " ("); });
  if (found) return *found;
  table_.fail("no column " + quotedText(name) + ", which is stated for " + std::string(role) +
              ", among " + names());
}

bool ColumnFinder::hasPlain(std::string_view name) const {
  return std::ranges::count(plain_, name) > 0;
}

/// Returns the column that is wanted; nothing if none is. Throws InputError if several are.
template <typename IsWanted>
std::optional<std::size_t> ColumnFinder::onlyOne(const IsWanted& isWanted) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < plain_.size(); ++i) {
    if (!isWanted(i)) continue;
    if (found) failTwice(*found, i);
    found = i;
  }
  return found;
}

}  // namespace rotatebook::recording
