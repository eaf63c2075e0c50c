#include "analysis/export/export_parts.h"

#include <algorithm>
#include <numeric>

#include "analysis/item.h"
#include "analysis/natural_order.h"

namespace promenade::analysis {

using study::Database;
using study::Statement;

std::vector<std::string> columns_of(Database& database, std::string_view table) {
  Statement row(database,
                "SELECT name FROM pragma_table_info(?) WHERE type <> 'BLOB' OR ?1 = 'sample'");
  row.bind(1, table);
  std::vector<std::string> columns;
  while (row.step()) columns.push_back(row.text(0));
  return columns;
}

bool has_column(Database& database, std::string_view table, std::string_view column) {
  Statement known(database, "SELECT 1 FROM pragma_table_info(?) WHERE name = ?");
  return known.bind(1, table).bind(2, column).step();
}

std::string column_or(Database& database, std::string_view table, std::string_view column,
                      std::string_view instead) {
  const bool known = has_column(database, table, column);
  return known ? std::string(table) + "." + std::string(column) : std::string(instead);
}

ExportColumn described(Database& database, std::string_view table, std::string_view column) {
  Statement row(database,
                "SELECT unit, meaning FROM dictionary WHERE table_name = ? AND column_name = ?");
  if (!row.bind(1, table).bind(2, column).step()) return {"", std::string(column), "", ""};
  return {"", std::string(column), row.text(0), row.text(1)};
}

const study::Instrument* find_instrument(const std::vector<study::Instrument>& instruments,
                                         std::string_view name, std::string_view version) {
  const auto found = std::find_if(instruments.begin(), instruments.end(), [&](const auto& one) {
    return one.name == name && one.version == version;
  });
  return found == instruments.end() ? nullptr : &*found;
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
