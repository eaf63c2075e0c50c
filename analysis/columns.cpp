#include "analysis/columns.h"

#include "study/sqlite.h"

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

}  // namespace promenade::analysis
