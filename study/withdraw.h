// A person who withdraws is taken out of the database, its journal and the backups that it
// knows, as the consent of the study says ([safety] withdraw). A tombstone stays, so that no
// merge brings the person back. In backups all rows of the person go, whatever the consent
// says: what may stay is in the database.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "study/sqlite.h"

namespace promenade::study {

using RowCounts = std::map<std::string, std::int64_t>;  // by table

struct ReachedBackup {
  std::string path;
  std::string problem;  // why the person may still be in it; empty: gone
};

struct Withdrawn {
  RowCounts removed;
  int unlinked = 0;  // sessions that stay, without what tells whose they are
  std::vector<ReachedBackup> backups;
};

// Throws InputError when nobody has the code, OutsideError while a session runs in the
// database or when it cannot be written; nothing is changed then. What could not be done in a
// backup is remembered in the database.
Withdrawn withdraw(const std::string& file, const std::string& code);

// Does what earlier withdrawals had to leave: in backups that were out of reach, and where the
// program was killed.
Withdrawn finish_withdrawals(const std::string& file);

// The backup is gone for good and nothing is to be done in it any more. Throws InputError when
// the database knows none at this path.
void forget_backup(const std::string& file, const std::string& path);

// For a merge, in its transaction and with foreign keys off: all rows of this participant.uuid.
RowCounts remove_person(Database& database, const std::string& uuid);
void remove_session(Database& database, const std::string& uuid, RowCounts& removed);
// After the transaction that removed somebody: not a byte of it is left in the file.
void scrub(Database& database);
// In the backups something waits to be removed, until clean_backups has reached them.
void mark_backups(Database& database);
std::vector<ReachedBackup> clean_backups(Database& database);

// A session that a process of this machine has open, `other` than this: its uuid, or "".
std::string running_session(Database& database, const std::string& other = "");

}  // namespace promenade::study
