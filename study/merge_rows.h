// Rows from one database to another of the same tables. Inside study/ only.
#pragma once

#include <string>
#include <vector>

#include "study/sqlite.h"

namespace promenade::study {

// Which rows: a condition with one place for `value`, and an order. Returns how many.
struct RowsOf {
  const char* table;
  const char* condition;
  const char* order;
};
std::int64_t copy_rows(Database& from, Database& to, const RowsOf& rows, const std::string& value);

// A session with all that belongs to it; `study`: its study.uuid where it comes to. Whether it
// runs is no matter any more.
using TakenRows = std::vector<std::pair<std::string, std::int64_t>>;
TakenRows copy_session(Database& from, Database& to, const std::string& session,
                       const std::string& study);

// The same for the same content of a session, in whatever file it stands.
std::string session_digest(Database& database, const std::string& session);

// Was the session interrupted in `shorter`, and has it gone on in `longer`?
bool has_gone_on(Database& shorter, Database& longer, const std::string& session);

}  // namespace promenade::study
