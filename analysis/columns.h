// Tables as the file has them: databases of older versions lack columns, and a public export
// puts views in their place.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::study {
class Database;
}

namespace promenade::analysis {

// The columns of a table, or of the view that hides it, in their order.
std::vector<std::string> columns_of(study::Database& database, std::string_view table);
bool has_column(study::Database& database, std::string_view table, std::string_view column);
// "table.column", or `instead` in databases of before there was one.
std::string column_or(study::Database& database, std::string_view table, std::string_view column,
                      std::string_view instead);

}  // namespace promenade::analysis
