#include "analysis/export/export_parts.h"

#include <algorithm>
#include <numeric>

#include "analysis/item.h"
#include "analysis/natural_order.h"

namespace promenade::analysis {

using study::Database;
using study::Statement;

ExportColumn described(Database& database, std::string_view table, std::string_view column) {
  Statement row(database,
                "SELECT unit, meaning FROM dictionary WHERE table_name = ? AND column_name = ?");
  if (!row.bind(1, table).bind(2, column).step()) return {"", std::string(column), "", ""};
  return {"", std::string(column), row.text(0), row.text(1)};
}

std::vector<int> session_order(const Log& log) {
  std::vector<int> order(log.sessions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return natural_less(item(log.sessions, a).code, item(log.sessions, b).code);
  });
  return order;
}

std::vector<bool> counting_sessions(const ExportSource& source) {
  std::vector<bool> counts(source.log.sessions.size(), false);
  for (const Person& person : source.selection.people) {
    if (person.disposition != Disposition::analysed) continue;
    counts[static_cast<std::size_t>(person.session)] = true;
  }
  return counts;
}

}  // namespace promenade::analysis
