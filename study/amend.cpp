#include "study/amend.h"

#include <algorithm>

#include "study/identity.h"
#include "study/process.h"
#include "study/store_open.h"
#include "study/stored_study.h"
#include "study/utf8.h"
#include "study/versions.h"

namespace promenade::study {
namespace {

constexpr int longest_reason = 2000;

void check_reason(const std::string& reason) {
  if (reason.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError("--reason", "is empty; say why the study is changed");
  }
  if (count_characters(reason) > longest_reason) {
    throw InputError("--reason", "has more than 2000 characters; say it shorter");
  }
}

// The newest version, of which `changed` is to be the next.
StudyVersion version_to_change(Database& database, const StudyBundle& changed) {
  const std::vector<StudyVersion> versions = study_versions(database);
  const std::string& file = database.file();
  if (versions.empty()) throw InputError(file, "holds no study yet; start it with `promenade run`");
  const StudyVersion& newest = versions.back();
  if (newest.name != changed.study.name) {
    throw InputError(file, "holds another study, \"" + newest.name +
                               "\"; name another database for \"" + changed.study.name + "\"");
  }
  if (newest.sha256 == changed.sha256) {
    throw InputError(changed.file, "is already the study in " + file + "; change it first");
  }
  for (std::size_t i = 0; i + 1 < versions.size(); ++i) {
    if (versions[i].sha256 != changed.sha256) continue;
    throw InputError(changed.file, "was the study in " + file + " before it was changed on " +
                                       versions[i + 1].amended_utc +
                                       "; to go back to it, give it another \"version\"");
  }
  return newest;
}

// How many of this version were interrupted; refuses while any session runs.
int count_interrupted(Database& database, const StudyVersion& version) {
  Statement row(database,
                "SELECT code, process, coalesce(process_start, ''), study FROM session "
                "JOIN participant ON participant.uuid = session.participant "
                "WHERE outcome = 'running' ORDER BY session.started_utc");
  int interrupted = 0;
  while (row.step()) {
    interrupted += row.text(3) == version.uuid ? 1 : 0;
    if (!lives(row.integer(1), row.text(2))) continue;
    throw OutsideError(database.file() + ": the session of \"" + row.text(0) +
                       "\" runs now; change the study when it has ended");
  }
  return interrupted;
}

// A version that this program cannot read any more has orders that nobody knows.
bool same_orders_as(Database& database, const StudyVersion& before, const StudyBundle& changed,
                    const InterfaceRegistry& registry) {
  try {
    return same_orders(read_stored_study(database, before.uuid, registry).study, changed.study);
  } catch (const InputError&) {
    return false;
  }
}

void put_amendment(Database& database, const std::string& study, const std::string& previous,
                   const std::string& reason, bool same) {
  Statement insert(database,
                   "INSERT INTO amendment(study, previous, reason, amended_utc, same_orders) "
                   "VALUES (?,?,?,?,?)");
  insert.bind(1, study).bind(2, previous).bind(3, reason).bind(4, utc_now()).bind(5, same).run();
}

}  // namespace

bool same_orders(const Study& before, const Study& after) {
  if (before.order != after.order) return false;
  if (after.order == Order::random && before.seed != after.seed) return false;
  return std::equal(before.interfaces.begin(), before.interfaces.end(), after.interfaces.begin(),
                    after.interfaces.end(),
                    [](const InterfaceUse& a, const InterfaceUse& b) { return a.name == b.name; });
}

Amended amend_study(const std::filesystem::path& path, const StudyBundle& changed,
                    const InterfaceRegistry& registry, const std::string& reason) {
  check_reason(reason);
  Database database = open_existing_store(path.string());
  Transaction transaction(database);
  const StudyVersion before = version_to_change(database, changed);
  Amended amended{before.version, same_orders_as(database, before, changed, registry),
                  count_interrupted(database, before)};
  put_amendment(database, put_study(database, changed), before.uuid, reason, amended.same_orders);
  transaction.commit();
  return amended;
}

}  // namespace promenade::study
