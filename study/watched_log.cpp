#include "study/watched_log.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/identity.h"
#include "study/plan.h"
#include "study/process.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

struct LoggedEvent {
  std::int64_t t_us = 0;
  std::string trial, kind, target, detail;
  double value = -1;
  bool by_experimenter = false;
};

// What the detail has under this key; empty: no text.
std::string text_in(const std::string& detail, const char* key) {
  const auto json = nlohmann::json::parse(detail, nullptr, false);
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

// study/session_pause.cpp says what stands still, and what goes on.
bool begins_stand(const LoggedEvent& event) {
  return event.kind == "pause" || event.kind == "leave" || event.kind == "interrupted";
}

void end_stand(FollowedSession& session, std::int64_t t_us) {
  if (!session.stands_since_us) return;
  const std::int64_t length_us = t_us - *session.stands_since_us;
  session.trial.stands.push_back({*session.stands_since_us, length_us});
  session.page_us += length_us;
  session.stands_since_us.reset();
  session.left = false;
}

void take_page(FollowedSession& session, const LoggedEvent& event) {
  session.told.page = event.target;
  session.place = static_cast<int>(event.value);
  session.page_us = event.t_us;
  session.trial.runs = false;
}

void take_answer(FollowedSession& session, const LoggedEvent& event) {
  if (!event.by_experimenter || event.detail.empty()) return;
  std::string request = text_in(event.detail, "request");
  if (request.empty()) return;
  const bool done = event.kind != "request_refused";
  session.told.answers.push_back(
      {std::move(request), done, done ? "" : text_in(event.detail, "why")});
}

void take(FollowedSession& session, const LoggedEvent& event) {
  session.event_us = event.t_us;
  take_answer(session, event);
  if (event.kind == "note") {
    session.told.notes.push_back({event.t_us, text_in(event.detail, "text")});
  } else if (event.kind == "request_refused") {
    // Changes nothing, a pause neither.
  } else if (begins_stand(event)) {
    if (!session.stands_since_us) session.stands_since_us = event.t_us;
    session.left |= event.kind == "leave";
  } else {
    end_stand(session, event.t_us);
  }
  if (event.kind == "interrupted" || event.kind == "return") session.gaps_s += event.value;
  if (event.kind == "page") take_page(session, event);
  if (event.trial.empty()) return;
  if (event.trial != session.trial.uuid) {
    session.trial = {};
    session.trial.uuid = event.trial;
    session.trial.runs = true;
  }
  if (event.kind == "late_frame") ++session.trial.told.late_frames;
}

void read_events(Database& database, FollowedSession& session) {
  Statement row(database,
                "SELECT seq, trial, t_us, kind, target, value, detail, actor FROM event "
                "WHERE session = ? AND seq > ? ORDER BY seq");
  row.bind(1, session.told.uuid).bind(2, session.seq);
  while (row.step()) {
    session.seq = row.integer(0);
    LoggedEvent event{row.integer(2), row.text(1), row.text(3), row.text(4), row.text(6)};
    event.value = row.real_if_any(5).value_or(-1);
    event.by_experimenter = row.text_view(7) == "experimenter";
    take(session, event);
  }
}

void read_trial(Database& database, FollowedTrial& trial) {
  Statement row(
      database,
      "SELECT position, attempt, practice, task, interface, target, limit_s, threshold_m, "
      "started_us, d_first, ended_us FROM trial WHERE uuid = ?");
  if (!row.bind(1, trial.uuid).step()) return;
  WatchedTrial& told = trial.told;
  told.position = static_cast<int>(row.integer(0));
  told.attempt = static_cast<int>(row.integer(1));
  told.practice = row.integer(2) != 0;
  told.task = row.text(3);
  told.interface = row.text(4);
  told.target = row.text(5);
  told.limit_s = row.real_if_any(6);
  told.threshold_m = row.real_if_any(7);
  trial.started_us = row.integer(8);
  if (const auto first = row.real_if_any(9); first && told.shown.empty()) {
    told.shown.push_back({0, *first});
    told.d_best = first;
  }
  trial.runs = row.is_null(10);
}

void read_samples(Database& database, FollowedTrial& trial) {
  Statement row(database,
                "SELECT rowid, t_us, d FROM sample WHERE trial = ? AND t_us >= ? AND rowid > ? "
                "AND d IS NOT NULL ORDER BY t_us, rowid");
  row.bind(1, trial.uuid).bind(2, trial.last_us).bind(3, trial.last_row);
  while (row.step()) {
    trial.last_row = row.integer(0);
    trial.last_us = row.integer(1);
    const double d = row.real(2);
    trial.told.shown.push_back({trial.seconds_at(trial.last_us), d});
    trial.told.d_best = std::min(trial.told.d_best.value_or(d), d);
  }
}

void count_trials(Database& database, WatchedSession& told) {
  Statement trials(database,
                   "SELECT count(*) FILTER (WHERE superseded = 0), coalesce(sum(late_frames), 0) "
                   "FROM trial WHERE session = ? AND ended_us IS NOT NULL");
  trials.bind(1, told.uuid).step();
  told.trials_done = static_cast<int>(trials.integer(0));
  told.late_frames = static_cast<int>(trials.integer(1));
  Statement frames(database,
                   "SELECT coalesce(sum(count), 0) FROM frame_histogram WHERE session = ? "
                   "AND trial IS NOT NULL AND measure = 'interval'");
  frames.bind(1, told.uuid).step();
  told.frames = frames.integer(0);
}

void read_end(Database& database, FollowedSession& session) {
  Statement row(database, "SELECT t_us FROM event WHERE session = ? ORDER BY seq DESC LIMIT 1");
  if (row.bind(1, session.told.uuid).step()) session.event_us = row.integer(0);
}

WatchedState state_of(const FollowedSession& session) {
  if (session.told.outcome != "running") return WatchedState::ended;
  if (session.left) return WatchedState::left;
  if (!lives(session.process, session.process_start)) return WatchedState::interrupted;
  return session.stands_since_us ? WatchedState::paused : WatchedState::running;
}

// What the page still takes by the simulated people, and all behind it.
std::optional<double> minutes_left_of(const FollowedSession& session) {
  const std::vector<double>& left = session.minutes_left;
  const auto place = static_cast<std::size_t>(session.place);
  if (session.place < 0 || place >= left.size()) return std::nullopt;
  const double behind = place + 1 < left.size() ? left[place + 1] : 0;
  const double here = static_cast<double>(session.reached_us() - session.page_us) / 60e6;
  return std::max(behind, left[place] - here);
}

}  // namespace

double FollowedTrial::seconds_at(std::int64_t t_us) const {
  std::int64_t since_us = t_us - started_us;
  for (const Stand& stand : stands) {
    if (stand.from_us >= started_us && stand.from_us < t_us) since_us -= stand.length_us;
  }
  return 1e-6 * static_cast<double>(std::max<std::int64_t>(0, since_us));
}

void follow(Database& database, FollowedSession& session) {
  const bool ended = session.told.outcome != "running";
  if (ended) {
    if (session.seq > 0) read_events(database, session);  // the last answers
    read_end(database, session);
    session.settled = session.process == 0;
  } else {
    read_events(database, session);
    if (session.trial.runs) read_trial(database, session.trial);
    if (session.trial.runs) read_samples(database, session.trial);
  }
  session.alive_us = std::max({session.alive_us, session.event_us, session.trial.last_us});
  count_trials(database, session.told);
}

WatchedSession told_of(const FollowedSession& session, const std::string& now_utc) {
  WatchedSession told = session.told;
  told.page_index = session.place;
  const double alive_s = 1e-6 * static_cast<double>(session.alive_us);
  told.state = state_of(session);
  told.minutes = alive_s / 60;
  const auto since_start_s = seconds_between(told.started_utc, now_utc);
  if (since_start_s) {
    told.silent_s = std::max(0.0, static_cast<double>(*since_start_s) - alive_s - session.gaps_s);
  }
  told.still_s = told.silent_s + 1e-6 * static_cast<double>(session.alive_us - session.event_us);
  if (told.state == WatchedState::ended) {
    const auto since_end_s = seconds_between(told.ended_utc, now_utc);
    told.ended_s = static_cast<double>(std::max<std::int64_t>(0, since_end_s.value_or(0)));
    told.page.clear();
    told.notes.clear();
    return told;
  }
  told.minutes_left = minutes_left_of(session);
  if (!session.trial.runs) return told;
  told.trial = session.trial.told;
  told.trial->seconds = session.trial.seconds_at(session.reached_us());
  return told;
}

}  // namespace promenade::study
