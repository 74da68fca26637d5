#include "cli/result_rows.h"

#include <fmt/ostream.h>

namespace rotatebook::cli {

void printRows(const ResultRows& rows, std::ostream& out) {
  for (const ResultRow& row : rows) {
    if (!row.text.empty())
      fmt::print(out, "  {:<{}}{}\n", row.label, row.label.empty() ? 0 : 12, row.text);
  }
}

Json jsonOf(const ResultRows& rows) {
  Json object;
  for (const ResultRow& row : rows) {
    if (!row.key.empty()) object[std::string(row.key)] = row.value;
  }
  return object;
}

}  // namespace rotatebook::cli
