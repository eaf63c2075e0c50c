#include "study/merge_rows.h"

#include <algorithm>
#include <array>

#include "study/identity.h"

namespace promenade::study {
namespace {

constexpr RowsOf session_row = {"session", "uuid = ?", "uuid"};
constexpr RowsOf event_rows = {"event", "session = ?", "seq"};
constexpr std::array<RowsOf, 5> session_parts = {
    {{"trial", "session = ?", "rowid"},
     event_rows,
     {"sample", "trial IN (SELECT uuid FROM trial WHERE session = ?)", "rowid"},
     {"answer", "session = ?", "rowid"},
     {"frame_histogram", "session = ?", "rowid"}}};

// What the place where a session stands decides, not the session.
constexpr std::array<std::string_view, 3> of_the_file = {"study", "process", "process_start"};

std::vector<std::string> columns_of(Database& database, const std::string& table) {
  Statement row(database, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
  row.bind(1, table);
  std::vector<std::string> columns;
  while (row.step()) columns.push_back(row.text(0));
  return columns;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

Statement select(Database& database, const std::vector<std::string>& columns, const RowsOf& rows,
                 const std::string& value) {
  Statement statement(database, "SELECT " + joined(columns) + " FROM " + rows.table + " WHERE " +
                                    rows.condition + " ORDER BY " + rows.order);
  statement.bind(1, value);
  return statement;
}

// As SQL would write them: every double with all its digits.
std::string text_of(Database& database, const RowsOf& rows, const std::string& value) {
  std::vector<std::string> columns;
  for (const std::string& column : columns_of(database, rows.table)) {
    const bool counts =
        std::find(of_the_file.begin(), of_the_file.end(), column) == of_the_file.end();
    if (counts) columns.push_back("quote(" + column + ")");
  }
  std::sort(columns.begin(), columns.end());  // old files have them in another order
  std::string text;
  Statement row = select(database, columns, rows, value);
  while (row.step()) {
    for (int column = 0; column < row.columns(); ++column) text += row.text(column) + ",";
    text += ";";
  }
  return text;
}

std::string text_in(Database& database, const char* sql, const std::string& session) {
  Statement row(database, sql);
  return row.bind(1, session).step() ? row.text(0) : "";
}

}  // namespace

std::int64_t copy_rows(Database& from, Database& to, const RowsOf& rows, const std::string& value) {
  const std::vector<std::string> columns = columns_of(to, rows.table);
  Statement row = select(from, columns, rows, value);
  Statement insert(to, std::string("INSERT INTO ") + rows.table + "(" + joined(columns) +
                           ") VALUES (" + joined(std::vector<std::string>(columns.size(), "?")) +
                           ")");
  std::int64_t count = 0;
  for (; row.step(); ++count) {
    for (int column = 0; column < row.columns(); ++column) {
      insert.bind_value(column + 1, row, column);
    }
    insert.run();
  }
  return count;
}

TakenRows copy_session(Database& from, Database& to, const std::string& session,
                       const std::string& study) {
  TakenRows taken = {{"session", copy_rows(from, to, session_row, session)}};
  Statement here(to,
                 "UPDATE session SET study = ?, process = NULL, process_start = NULL "
                 "WHERE uuid = ?");
  here.bind(1, study).bind(2, session).run();
  for (const RowsOf& part : session_parts) {
    taken.emplace_back(part.table, copy_rows(from, to, part, session));
  }
  return taken;
}

std::string session_digest(Database& database, const std::string& session) {
  std::string text = text_in(database,
                             "SELECT study_sha256 FROM study WHERE uuid = (SELECT study FROM "
                             "session WHERE uuid = ?)",
                             session);
  text += text_of(database, session_row, session);
  for (const RowsOf& part : session_parts) text += part.table + text_of(database, part, session);
  return sha256_hex(text);
}

bool has_gone_on(Database& shorter, Database& longer, const std::string& session) {
  // Or its outcome was certain, and its last page open.
  const std::string open =
      text_in(shorter,
              "SELECT outcome = 'running' OR NOT EXISTS (SELECT 1 FROM event WHERE session = "
              "one.uuid AND kind IN ('continue', 'stop') AND seq > (SELECT max(seq) FROM event "
              "WHERE session = one.uuid AND kind = 'page')) FROM session AS one WHERE uuid = ?",
              session);
  if (open != "1") return false;
  // Events are only ever added.
  const std::string before = text_of(shorter, event_rows, session);
  const std::string after = text_of(longer, event_rows, session);
  return after.size() > before.size() && after.compare(0, before.size(), before) == 0;
}

}  // namespace promenade::study
