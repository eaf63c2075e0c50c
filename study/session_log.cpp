#include "study/session_log.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "motion/bytes.h"
#include "study/identity.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

LoggedSession header_of(Database& database, const std::string& uuid) {
  Statement row(database,
                "SELECT session.study, participant.code, station, language, outcome, started_utc, "
                "simulated, pilot, sequence, seed, alive_us, machine FROM session "
                "JOIN participant ON participant.uuid = session.participant "
                "WHERE session.uuid = ?");
  if (!row.bind(1, uuid).step()) throw InputError(database.file(), "has no session " + uuid);
  LoggedSession session;
  session.uuid = uuid;
  session.study_uuid = row.text(0);
  session.participant = row.text(1);
  session.station = row.text(2);
  session.language = row.text(3);
  session.outcome = row.text(4);
  session.started_utc = row.text(5);
  session.simulated = row.integer(6) != 0;
  session.pilot = row.integer(7) != 0;
  session.sequence = static_cast<int>(row.integer(8));
  session.seed = static_cast<std::uint64_t>(row.integer(9));
  session.last_us = row.integer(10);
  session.machine = row.text(11);
  return session;
}

TrialEnded ended_in(const Statement& row, int from) {
  TrialEnded ended;
  const auto count = [&row](int column) { return static_cast<int>(row.integer(column)); };
  ended.t_us = row.integer(from);
  ended.d_best = row.real_if_any(from + 1);
  ended.d_final = row.real_if_any(from + 2);
  ended.d_sum = row.real_if_any(from + 3);
  ended.seconds_difference = row.real_if_any(from + 4);
  if (!row.is_null(from + 5)) ended.first_below_us = row.integer(from + 5);
  ended.paused_us = row.integer(from + 6);
  ended.clicks = count(from + 7);
  ended.changes = count(from + 8);
  ended.late_frames = count(from + 9);
  ended.process = {row.real_if_any(from + 10), row.real(from + 11),    count(from + 12),
                   count(from + 13),           count(from + 14),       count(from + 15),
                   row.real(from + 16),        row.integer(from + 17), count(from + 18)};
  return ended;
}

std::map<std::string, int> read_trials(Database& database, LoggedSession& session) {
  Statement row(database,
                "SELECT uuid, position, attempt, superseded, task, interface, target, started_us, "
                "outcome, d_first, ended_us, d_best, d_final, d_sum, seconds_difference, "
                "first_below_us, paused_us, clicks, changes, late_frames, d_area_m_s, path_m, "
                "reversals, drags, controls_touched, examples_visited, map_coverage, idle_us, "
                "camera_moves FROM trial WHERE session = ? ORDER BY started_us, rowid");
  row.bind(1, session.uuid);
  std::map<std::string, int> index;
  while (row.step()) {
    LoggedTrial trial;
    trial.uuid = row.text(0);
    trial.position = static_cast<int>(row.integer(1));
    trial.attempt = static_cast<int>(row.integer(2));
    trial.superseded = row.integer(3) != 0;
    trial.task = row.text(4);
    trial.interface = row.text(5);
    trial.target = row.text(6);
    trial.started_us = row.integer(7);
    trial.outcome = row.text(8);
    trial.d_first = row.real_if_any(9);
    trial.ended = ended_in(row, 10);
    index[trial.uuid] = static_cast<int>(session.trials.size());
    session.trials.push_back(std::move(trial));
  }
  return index;
}

int trial_in(const Statement& row, int column, const std::map<std::string, int>& trials) {
  const auto found = trials.find(row.text(column));
  return found == trials.end() ? -1 : found->second;
}

Actor actor_of(const std::string& word) {
  if (word == "participant") return Actor::participant;
  return word == "experimenter" ? Actor::experimenter : Actor::system;
}

LoggedStep event_in(const Statement& row, const std::map<std::string, int>& trials) {
  LoggedStep step;
  step.trial = trial_in(row, 0, trials);
  Event& event = step.event;
  event.t_us = row.integer(2);
  event.uncertainty_us = row.integer(3);
  event.frame_us = row.is_null(4) ? -1 : row.integer(4);
  event.actor = actor_of(row.text(5));
  event.kind = row.text(6);
  event.target = row.text(7);
  event.value = row.real_if_any(8);
  event.x = row.real_if_any(9);
  event.y = row.real_if_any(10);
  event.detail = row.text(11);
  return step;
}

LoggedStep sample_in(const Statement& row, const std::map<std::string, int>& trials,
                     const std::string& file) {
  LoggedStep step;
  step.sample = true;
  step.trial = trial_in(row, 0, trials);
  step.shown.t_us = row.integer(2);
  step.shown.d = row.real_if_any(3);
  const std::string_view bytes = row.blob(4);
  step.shown.weights.resize(static_cast<Eigen::Index>(bytes.size() / sizeof(double)));
  ByteReader(bytes, file).numbers(step.shown.weights.data(), bytes.size() / sizeof(double));
  return step;
}

// Samples stand behind the event that they name; those of one event in their own order.
void read_steps(Database& database, const std::map<std::string, int>& trials,
                LoggedSession& session) {
  Statement events(database,
                   "SELECT trial, seq, t_us, uncertainty_us, frame_us, actor, kind, target, value, "
                   "x, y, detail FROM event WHERE session = ? ORDER BY seq");
  Statement samples(database,
                    "SELECT sample.trial, after_seq, sample.t_us, d, weights FROM sample "
                    "JOIN trial ON trial.uuid = sample.trial WHERE trial.session = ? "
                    "ORDER BY after_seq, sample.t_us, sample.rowid");
  events.bind(1, session.uuid);
  samples.bind(1, session.uuid);
  bool more = samples.step();
  const auto take_samples = [&](std::int64_t before) {
    while (more && (before < 0 || samples.integer(1) < before)) {
      session.steps.push_back(sample_in(samples, trials, database.file()));
      more = samples.step();
    }
  };
  while (events.step()) {
    session.last_seq = events.integer(1);
    take_samples(session.last_seq);
    session.steps.push_back(event_in(events, trials));
  }
  take_samples(-1);
  for (const LoggedStep& step : session.steps) {
    session.last_us = std::max(session.last_us, step.t_us());
  }
}

void read_answers(Database& database, LoggedSession& session) {
  Statement row(
      database,
      "SELECT instrument, version, item, value, text, declined, touched, t_us FROM answer "
      "WHERE session = ? ORDER BY rowid");
  row.bind(1, session.uuid);
  while (row.step()) {
    Answer answer;
    answer.instrument = row.text(0);
    answer.version = row.text(1);
    answer.item = row.text(2);
    answer.value = row.real_if_any(3);
    answer.text = row.text(4);
    answer.declined = row.integer(5) != 0;
    answer.touched = row.integer(6) != 0;
    answer.t_us = row.integer(7);
    session.answers.push_back(std::move(answer));
  }
}

}  // namespace

LoggedSession read_session(Database& database, const std::string& uuid) {
  LoggedSession session = header_of(database, uuid);
  read_answers(database, session);
  read_steps(database, read_trials(database, session), session);
  return session;
}

std::int64_t gap_us(const LoggedSession& session, const std::string& now_utc) {
  const auto since_start_s = seconds_between(session.started_utc, now_utc);
  if (!since_start_s) return 0;
  double gap_s = static_cast<double>(*since_start_s) - 1e-6 * static_cast<double>(session.last_us);
  for (const LoggedStep& step : session.steps) {
    const bool gap = step.event.kind == "interrupted" || step.event.kind == "return";
    if (!step.sample && gap) gap_s -= step.event.value.value_or(0);
  }
  return std::max<std::int64_t>(0, std::llround(1e6 * gap_s));
}

std::vector<std::string> session_uuids(Database& database) {
  Statement row(database, "SELECT uuid FROM session ORDER BY started_utc, rowid");
  std::vector<std::string> uuids;
  while (row.step()) uuids.push_back(row.text(0));
  return uuids;
}

}  // namespace promenade::study
