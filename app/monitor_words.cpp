#include "app/monitor_words.h"

#include <fmt/format.h>

#include <cmath>

namespace promenade::app {
namespace {

using study::Texts;
using study::WatchedSession;
using study::WatchedState;

constexpr double silent_after_s = 5;  // the program says once a second that it lives

std::string count_of(const Texts& texts, const char* key, double count) {
  return texts.with(key, {{"count", fmt::format("{:.0f}", std::floor(count))}});
}

// By the names of study::PageKind.
std::string page_doing(const Texts& texts, const WatchedSession& session) {
  if (session.page.empty()) return texts("watch.begun");
  const std::string* known = texts.find("watch.at_" + session.page);
  return known != nullptr ? *known : texts.with("watch.other_page", {{"page", session.page}});
}

std::string place_words(const Texts& texts, const WatchedSession& session) {
  const study::WatchedTrial& trial = *session.trial;
  std::string words = texts.with(
      session.trials > 0 ? "watch.number_of" : "watch.number",
      {{"trial", std::to_string(trial.position)}, {"count", std::to_string(session.trials)}});
  if (trial.practice) words += texts("watch.practice");
  if (trial.attempt > 1) {
    words += texts.with("watch.attempt", {{"attempt", std::to_string(trial.attempt)}});
  }
  return words;
}

}  // namespace

std::string duration_words(const Texts& texts, double seconds) {
  if (seconds < 100) return count_of(texts, "watch.seconds", seconds);
  if (seconds < 100 * 60) return count_of(texts, "watch.minutes", seconds / 60);
  if (seconds < 48 * 3600) return count_of(texts, "watch.hours", seconds / 3600);
  return count_of(texts, "watch.days", seconds / 86400);
}

std::string kind_words(const Texts& texts, const WatchedSession& session) {
  if (session.simulated) return texts("watch.simulated");
  return texts(session.pilot ? "watch.pilot" : "watch.real");
}

std::string outcome_words(const Texts& texts, const WatchedSession& session) {
  const std::string* known = texts.find("watch.outcome_" + session.outcome);
  return known != nullptr ? *known : session.outcome;
}

std::string doing_words(const Texts& texts, const WatchedSession& session) {
  const std::string place =
      session.trial ? place_words(texts, session) : page_doing(texts, session);
  switch (session.state) {
    case WatchedState::running:
      return place;
    case WatchedState::paused:
      return texts.with("watch.paused", {{"doing", place}});
    case WatchedState::left:
      return texts.with("watch.left", {{"trial", std::to_string(session.trials_done)}});
    case WatchedState::interrupted:
      return texts.with("watch.interrupted", {{"time", duration_words(texts, session.silent_s)}});
    case WatchedState::ended:
      return outcome_words(texts, session);
  }
  return place;
}

std::string advice_words(const Texts& texts, const WatchedSession& session) {
  return session.state == WatchedState::interrupted ? texts("watch.start_again") : "";
}

std::string trial_words(const Texts& texts, const WatchedSession& session) {
  if (!session.trial) return "";
  const study::WatchedTrial& trial = *session.trial;
  std::string words = trial.task;
  if (!trial.interface.empty()) {
    words = texts.with("watch.with_interface", {{"task", words}, {"interface", trial.interface}});
  }
  if (trial.target.empty()) return words;
  return texts.with("watch.to_target", {{"what", words}, {"target", trial.target}});
}

std::string time_words(const Texts& texts, const WatchedSession& session) {
  const std::string minutes = fmt::format("{:.0f}", std::floor(session.minutes));
  if (!session.minutes_left) return texts.with("watch.played", {{"minutes", minutes}});
  return texts.with(
      "watch.played_left",
      {{"minutes", minutes}, {"left", fmt::format("{:.0f}", std::ceil(*session.minutes_left))}});
}

bool is_silent(const WatchedSession& session) {
  const bool plays =
      session.state == WatchedState::running || session.state == WatchedState::paused;
  return plays && session.silent_s > silent_after_s;
}

std::string life_words(const Texts& texts, const WatchedSession& session) {
  if (is_silent(session)) {
    return texts.with("watch.silent", {{"time", duration_words(texts, session.silent_s)}});
  }
  return texts.with("watch.last_event", {{"time", duration_words(texts, session.still_s)}});
}

std::string frames_words(const Texts& texts, const WatchedSession& session) {
  if (session.frames == 0) return "";
  return texts.with("watch.late", {{"late", std::to_string(session.late_frames)},
                                   {"count", std::to_string(session.frames)}});
}

std::string finished_words(const Texts& texts, const study::Watched& now) {
  const char* key = now.planned > 0     ? "watch.finished_of"
                    : now.finished == 1 ? "watch.finished_one"
                                        : "watch.finished_many";
  std::string words = texts.with(
      key, {{"done", std::to_string(now.finished)}, {"planned", std::to_string(now.planned)}});
  const auto add = [&](const char* more, int count) {
    if (count > 0) words += texts.with(more, {{"count", std::to_string(count)}});
  };
  add("watch.and_pilots", now.finished_pilot);
  add("watch.and_simulated", now.finished_simulated);
  return words;
}

std::string problem_words(const Texts& texts, const study::Watched& now) {
  if (now.waits) return texts("watch.waits");
  if (now.is_locked) return texts("watch.locked");
  if (now.is_input_error) return texts.with("watch.wrong", {{"problem", now.problem}});
  return now.problem;
}

std::string clock_words(std::int64_t t_us) {
  const std::int64_t seconds = t_us / 1'000'000;
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace promenade::app
