// A folder that goes away with its test, and what stands in the databases in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "study/sqlite.h"
#include "tests/test_folder.h"

namespace promenade::study {

class FolderTest : public testing::Test {
 protected:
  std::string file(const std::string& name = "toy.db") const { return own_.file(name); }

  TestFolder own_;
  const std::filesystem::path& folder_ = own_.path();
};

inline std::int64_t number_in(Database& database, const std::string& sql) {
  Statement statement(database, sql);
  return statement.step() ? statement.integer(0) : -1;
}
inline std::int64_t number_in(const std::string& file, const std::string& sql) {
  Database database(file, Database::Mode::read_only);
  return number_in(database, sql);
}

inline std::vector<std::string> texts_in(Database& database, const std::string& sql) {
  Statement statement(database, sql);
  std::vector<std::string> texts;
  while (statement.step()) texts.push_back(statement.text(0));
  return texts;
}

// Every row of these columns, as SQL would write it, in the order of the table.
inline std::string rows_of(Database& database, const std::string& table,
                           const std::vector<std::string>& columns) {
  std::string quoted;
  for (const std::string& column : columns) {
    quoted += (quoted.empty() ? "quote(" : " || ',' || quote(") + column + ")";
  }
  std::string rows;
  for (const std::string& row : texts_in(database, "SELECT " + quoted + " FROM " + table)) {
    rows += row + "\n";
  }
  return rows;
}

inline std::vector<std::string> columns_of(Database& database, const std::string& table) {
  return texts_in(database, "SELECT name FROM pragma_table_info('" + table + "') ORDER BY cid");
}

inline std::vector<std::string> tables_of(Database& database) {
  return texts_in(database, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
}

using Content = std::map<std::string, std::string>;  // table to rows

inline Content content_of(Database& database, const std::vector<std::string>& but = {}) {
  Content content;
  for (const std::string& table : tables_of(database)) {
    if (std::find(but.begin(), but.end(), table) != but.end()) continue;
    content[table] = rows_of(database, table, columns_of(database, table));
  }
  return content;
}
inline Content content_of(const std::string& file, const std::vector<std::string>& but = {}) {
  Database database(file, Database::Mode::read_only);
  return content_of(database, but);
}

// The message of an error of either kind; "" when nothing was thrown.
template <typename Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace promenade::study
