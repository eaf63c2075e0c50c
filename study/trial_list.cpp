#include "study/trial_list.h"

#include "study/sqlite.h"

namespace promenade::study {
namespace {

constexpr const char* query =
    "SELECT trial.uuid, session.uuid, participant.code, simulated, pilot, practice, position, "
    "attempt, superseded, task, interface, target, trial.outcome, "
    "(ended_us - started_us - paused_us) / 1e6, d_final, "
    "julianday(started_utc) * 86400 + ended_us / 1e6 FROM trial "
    "JOIN session ON session.uuid = trial.session "
    "JOIN participant ON participant.uuid = session.participant "
    "ORDER BY started_utc, session.rowid, started_us, trial.rowid";

ListedTrial trial_in(const Statement& row) {
  ListedTrial trial;
  trial.uuid = row.text(0);
  trial.session = row.text(1);
  trial.participant = row.text(2);
  trial.simulated = row.integer(3) != 0;
  trial.pilot = row.integer(4) != 0;
  trial.practice = row.integer(5) != 0;
  trial.position = static_cast<int>(row.integer(6));
  trial.attempt = static_cast<int>(row.integer(7));
  trial.superseded = row.integer(8) != 0;
  trial.task = row.text(9);
  trial.interface = row.text(10);
  trial.target = row.text(11);
  trial.outcome = row.text(12);
  if (!row.is_null(13)) trial.seconds = row.real(13);
  if (!row.is_null(14)) trial.d_final = row.real(14);
  trial.ended_s = trial.outcome.empty() ? 0 : row.real(15);
  return trial;
}

}  // namespace

std::vector<ListedTrial> list_trials(Database& database) {
  std::vector<ListedTrial> trials;
  Statement row(database, query);
  while (row.step()) trials.push_back(trial_in(row));
  return trials;
}

ListedTrial choose_trial(Database& database, const std::string& uuid) {
  const std::vector<ListedTrial> trials = list_trials(database);
  const ListedTrial* chosen = nullptr;
  for (const ListedTrial& trial : trials) {
    const bool later = chosen == nullptr || trial.ended_s >= chosen->ended_s;
    if (uuid.empty() ? !trial.outcome.empty() && later : trial.uuid == uuid) chosen = &trial;
  }
  if (chosen != nullptr) return *chosen;
  throw InputError(database.file(),
                   (uuid.empty() ? "has no trial that has ended" : "has no trial " + uuid) +
                       "; `promenade replay " + database.file() + " --list` names those it has");
}

}  // namespace promenade::study
