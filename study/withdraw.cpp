#include "study/withdraw.h"

#include <algorithm>
#include <filesystem>

#include "motion/did_you_mean.h"
#include "study/control.h"
#include "study/identity.h"
#include "study/migrate.h"
#include "study/process.h"
#include "study/schema.h"
#include "study/store_open.h"
#include "study/study.h"
#include "study/toml_parse.h"

namespace promenade::study {
namespace {

constexpr const char* no_date = "0001-01-01T00:00:00Z";

using Values = std::vector<std::string>;

Statement with_values(Database& database, const std::string& sql, const Values& values) {
  Statement statement(database, sql);
  for (std::size_t i = 0; i < values.size(); ++i) {
    statement.bind(static_cast<int>(i) + 1, values[i]);
  }
  return statement;
}

std::string text_of(Database& database, const std::string& sql, const std::string& value) {
  Statement row = with_values(database, sql, {value});
  return row.step() ? row.text(0) : "";
}

std::vector<std::string> texts_of(Database& database, const std::string& sql,
                                  const Values& values = {}) {
  Statement row = with_values(database, sql, values);
  std::vector<std::string> texts;
  while (row.step()) texts.push_back(row.text(0));
  return texts;
}

bool has_table(Database& database, const std::string& table) {
  return !text_of(database, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name = ?",
                  table)
              .empty();
}

// Runs a change and returns how many rows it met.
std::int64_t change(Database& database, const std::string& sql, const Values& values) {
  with_values(database, sql, values).run();
  Statement changes(database, "SELECT changes()");
  changes.step();
  return changes.integer(0);
}

const TomlValue* find(const TomlValue* table, std::string_view key) {
  if (!table) return nullptr;
  for (const TomlValue::Entry& entry : table->entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

// A text that cannot be read promises to keep nothing.
Withdrawal promised_in(const std::string& config_text) {
  const ParsedToml parsed = parse_lines_of_toml("", config_text);
  const TomlValue* word = find(find(&parsed.root, "safety"), "withdraw");
  return word && word->text == "link" ? Withdrawal::link : Withdrawal::everything;
}

Withdrawal promised_to(Database& database, const std::string& session) {
  return promised_in(text_of(database,
                             "SELECT config_text FROM study JOIN session ON session.study = "
                             "study.uuid WHERE session.uuid = ?",
                             session));
}

std::vector<std::string> sessions_of(Database& database, const std::string& participant) {
  return texts_of(database, "SELECT uuid FROM session WHERE participant = ?", {participant});
}

constexpr const char* tables_by_session[] = {"event", "answer", "frame_histogram"};

// Its trials get other names, too: an export of before may list the old ones beside a code.
void rename_trials(Database& database, const std::string& session) {
  for (const std::string& trial :
       texts_of(database, "SELECT uuid FROM trial WHERE session = ?", {session})) {
    const std::string fresh = random_uuid();
    change(database, "UPDATE sample SET trial = ? WHERE trial = ?", {fresh, trial});
    change(database, "UPDATE answer SET about = ? WHERE session = ? AND about = ?",
           {fresh, session, trial});
    for (const char* table : tables_by_session) {
      change(database,
             std::string("UPDATE ") + table + " SET trial = ? WHERE session = ? AND trial = ?",
             {fresh, session, trial});
    }
    change(database, "UPDATE trial SET uuid = ? WHERE uuid = ?", {fresh, trial});
  }
}

void unlink_session(Database& database, const std::string& session) {
  rename_trials(database, session);
  const std::string fresh = random_uuid();
  for (const char* table : {"event", "answer", "frame_histogram", "trial"}) {
    change(database, std::string("UPDATE ") + table + " SET session = ? WHERE session = ?",
           {fresh, session});
  }
  change(database,
         "UPDATE session SET uuid = ?, outcome = 'withdrawn', started_utc = ?, ended_utc = ?, "
         "station = '', machine = '{}', process = NULL, process_start = NULL WHERE uuid = ?",
         {fresh, no_date, no_date, session});
}

void unlink_participant(Database& database, const std::string& participant) {
  const std::string fresh = random_uuid();
  change(database, "UPDATE session SET participant = ? WHERE participant = ?",
         {fresh, participant});
  change(database, "UPDATE participant SET uuid = ?, code = ? WHERE uuid = ?",
         {fresh, "withdrawn-" + random_uuid().substr(0, 8), participant});
}

void remove_from_roster(Database& database, const std::string& participant, RowCounts& removed) {
  if (!has_table(database, "roster")) return;
  const std::string code =
      text_of(database, "SELECT code FROM participant WHERE uuid = ?", participant);
  removed["roster"] += change(database, "DELETE FROM roster WHERE code = ?", {code});
  change(database, "UPDATE roster SET replaces = NULL WHERE replaces = ?", {code});
}

void take_out(Database& database, const std::string& participant, Withdrawn& withdrawn) {
  for (const std::string& session : sessions_of(database, participant)) {
    if (promised_to(database, session) == Withdrawal::link) {
      unlink_session(database, session);
      ++withdrawn.unlinked;
    } else {
      remove_session(database, session, withdrawn.removed);
    }
  }
  const bool stays = withdrawn.unlinked > 0;
  if (stays) {
    remove_from_roster(database, participant, withdrawn.removed);
    unlink_participant(database, participant);
  } else {
    for (const auto& [table, rows] : remove_person(database, participant)) {
      withdrawn.removed[table] += rows;
    }
  }
  change(database, "INSERT INTO tombstone(participant, withdrawn_utc, removed) VALUES (?,?,?)",
         {participant, utc_now(), stays ? "link" : "everything"});
  mark_backups(database);
}

std::string participant_of(Database& database, const std::string& code) {
  const std::string uuid = text_of(database, "SELECT uuid FROM participant WHERE code = ?", code);
  if (!uuid.empty()) return uuid;
  throw InputError(database.file(),
                   "nobody in it has the code \"" + code + "\"; nothing was removed" +
                       did_you_mean(code, texts_of(database, "SELECT code FROM participant")));
}

void refuse_running(Database& database) {
  if (running_session(database).empty()) return;
  throw OutsideError(database.file() +
                     ": a session runs in it; wait until it has ended, then withdraw");
}

void empty_journal(Database& database) {
  Statement checkpoint(database, "PRAGMA wal_checkpoint(TRUNCATE)");
  if (checkpoint.step() && checkpoint.integer(0) == 0) return;
  throw OutsideError(database.file() +
                     ": another program reads it, and its journal may still hold what was "
                     "removed; close that one and call `promenade withdraw` without a code");
}

// Those who withdrew are withdrawn in the other database as well, and never come back there.
void apply_tombstones(Database& from, Database& to) {
  const bool remember = has_table(to, "tombstone");  // not in older versions
  Statement grave(from, "SELECT participant, withdrawn_utc, removed FROM tombstone");
  while (grave.step()) {
    remove_person(to, grave.text(0));
    if (!remember) continue;
    change(to,
           "INSERT OR IGNORE INTO tombstone(participant, withdrawn_utc, removed) VALUES (?,?,?)",
           {grave.text(0), grave.text(1), grave.text(2)});
  }
}

void clean_backup(const std::string& path, Database& withdrawn_from) {
  if (!std::filesystem::is_regular_file(path)) {
    throw OutsideError("it is not there; connect its disk, or take it off the list with --forget");
  }
  Database database(path, Database::Mode::read_write);
  check_database(database);
  database.exec("PRAGMA secure_delete = ON");
  database.exec("PRAGMA foreign_keys = OFF");
  Transaction transaction(database);
  apply_tombstones(withdrawn_from, database);
  transaction.commit();
  scrub(database);
}

ReachedBackup reach_backup(const std::string& path, Database& withdrawn_from) {
  try {
    clean_backup(path, withdrawn_from);
    return {path, ""};
  } catch (const std::exception& error) {
    return {path, error.what()};
  }
}

Database open_for_withdrawal(const std::string& file) {
  Database database = open_existing_store(file);
  // Each deleted trial would look for itself in all events; whole persons go here.
  database.exec("PRAGMA foreign_keys = OFF");
  return database;
}

}  // namespace

std::string running_session(Database& database, const std::string& other) {
  Statement row(database,
                "SELECT uuid, process, coalesce(process_start, '') FROM session WHERE process "
                "IS NOT NULL AND uuid <> ?");
  row.bind(1, other);
  while (row.step()) {
    if (lives(row.integer(1), row.text(2))) return row.text(0);
  }
  return "";
}

void remove_session(Database& database, const std::string& session, RowCounts& removed) {
  removed["sample"] += change(
      database, "DELETE FROM sample WHERE trial IN (SELECT uuid FROM trial WHERE session = ?)",
      {session});
  for (const char* table : {"event", "answer", "frame_histogram", "trial"}) {
    if (!has_table(database, table)) continue;  // in a backup of an older version
    removed[table] +=
        change(database, std::string("DELETE FROM ") + table + " WHERE session = ?", {session});
  }
  removed["session"] += change(database, "DELETE FROM session WHERE uuid = ?", {session});
}

RowCounts remove_person(Database& database, const std::string& uuid) {
  RowCounts removed;
  for (const std::string& session : sessions_of(database, uuid)) {
    remove_session(database, session, removed);
  }
  remove_from_roster(database, uuid, removed);
  removed["participant"] += change(database, "DELETE FROM participant WHERE uuid = ?", {uuid});
  return removed;
}

void scrub(Database& database) {
  empty_journal(database);
  database.exec("VACUUM");
  empty_journal(database);
}

void mark_backups(Database& database) {
  change(database, "UPDATE backup SET withdrawal_due_utc = ? WHERE withdrawal_due_utc IS NULL",
         {utc_now()});
}

std::vector<ReachedBackup> clean_backups(Database& database) {
  std::vector<ReachedBackup> backups;
  for (const std::string& path :
       texts_of(database, "SELECT path FROM backup WHERE withdrawal_due_utc IS NOT NULL")) {
    backups.push_back(reach_backup(path, database));
    if (!backups.back().problem.empty()) continue;
    change(database, "UPDATE backup SET withdrawal_due_utc = NULL WHERE path = ?", {path});
  }
  return backups;
}

Withdrawn withdraw(const std::string& file, const std::string& code) {
  {
    Database log = open_log(file);  // nothing is written for somebody who is not there
    participant_of(log, code);
    refuse_running(log);
  }
  Database database = open_for_withdrawal(file);
  Withdrawn withdrawn;
  Transaction transaction(database);
  refuse_running(database);
  take_out(database, participant_of(database, code), withdrawn);
  transaction.commit();
  scrub(database);
  remove_requests(file);
  withdrawn.backups = clean_backups(database);
  return withdrawn;
}

Withdrawn finish_withdrawals(const std::string& file) {
  Database database = open_for_withdrawal(file);
  refuse_running(database);
  scrub(database);
  remove_requests(file);
  return {{}, 0, clean_backups(database)};
}

void forget_backup(const std::string& file, const std::string& path) {
  Database database = open_existing_store(file);
  const std::string full = std::filesystem::absolute(path).lexically_normal().string();
  if (change(database, "DELETE FROM backup WHERE path = ?", {full}) > 0) return;
  throw InputError(file, "knows no backup " + full +
                             did_you_mean(full, texts_of(database, "SELECT path FROM backup")));
}

}  // namespace promenade::study
