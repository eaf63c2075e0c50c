#include "app/monitor_words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace promenade::app {
namespace {

using study::WatchedSession;
using study::WatchedState;

constexpr double silent_after_s = 5;  // the program says once a second that it lives

// By the names of study::PageKind.
constexpr auto page_words = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"language", "chooses a language"},
    {"welcome", "reads the first page"},
    {"consent", "reads the consent page"},
    {"instructions", "reads the instructions"},
    {"intro", "is about to begin a trial"},
    {"questionnaire", "answers questions"},
    {"release", "has practised, and waits for the experimenter"},
    {"break", "has a break"},
    {"thanks", "reads the last page"},
    {"declined", "has declined"},
});

std::string page_doing(const WatchedSession& session) {
  for (const auto& [page, words] : page_words) {
    if (session.page == page) return std::string(words);
  }
  return session.page.empty() ? "has just begun" : "is at the page \"" + session.page + "\"";
}

std::string place_words(const WatchedSession& session) {
  const study::WatchedTrial& trial = *session.trial;
  std::string words = fmt::format("trial {}", trial.position);
  if (session.trials > 0) words += fmt::format(" of {}", session.trials);
  if (trial.practice) words += ", practice";
  if (trial.attempt > 1) words += fmt::format(", attempt {}", trial.attempt);
  return words;
}

}  // namespace

std::string duration_words(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", std::floor(seconds));
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", std::floor(seconds / 60));
  if (seconds < 48 * 3600) return fmt::format("{:.0f} h", std::floor(seconds / 3600));
  return fmt::format("{:.0f} days", std::floor(seconds / 86400));
}

std::string kind_words(const WatchedSession& session) {
  if (session.simulated) return "simulated";
  return session.pilot ? "pilot" : "real";
}

std::string doing_words(const WatchedSession& session) {
  const std::string place = session.trial ? place_words(session) : page_doing(session);
  switch (session.state) {
    case WatchedState::running:
      return place;
    case WatchedState::paused:
      return "paused: " + place;
    case WatchedState::left:
      return "goes on another day, after trial " + std::to_string(session.trials_done);
    case WatchedState::interrupted:
      return "interrupted " + duration_words(session.silent_s) +
             " ago: start the program again to resume";
    case WatchedState::ended:
      return session.outcome;
  }
  return place;
}

std::string trial_words(const WatchedSession& session) {
  if (!session.trial) return "";
  const study::WatchedTrial& trial = *session.trial;
  std::string words = trial.task;
  if (!trial.interface.empty()) words += " with " + trial.interface;
  return trial.target.empty() ? words : words + ", to " + trial.target;
}

std::string time_words(const WatchedSession& session) {
  std::string words = fmt::format("{:.0f} min played", std::floor(session.minutes));
  if (!session.minutes_left) return words;
  return words + fmt::format(", about {:.0f} left", std::ceil(*session.minutes_left));
}

bool is_silent(const WatchedSession& session) {
  const bool plays =
      session.state == WatchedState::running || session.state == WatchedState::paused;
  return plays && session.silent_s > silent_after_s;
}

std::string life_words(const WatchedSession& session) {
  if (is_silent(session)) return "no sign of life for " + duration_words(session.silent_s);
  return "last event " + duration_words(session.still_s) + " ago";
}

std::string frames_words(const WatchedSession& session) {
  if (session.frames == 0) return "";
  return fmt::format("{} late of {} frames", session.late_frames, session.frames);
}

std::string finished_words(const study::Watched& now) {
  std::string words = std::to_string(now.finished);
  if (now.planned > 0) words += fmt::format(" of {}", now.planned);
  words += now.finished == 1 && now.planned == 0 ? " participant has" : " participants have";
  words += " finished";
  if (now.finished_pilot > 0) words += fmt::format(", {} pilot", now.finished_pilot);
  if (now.finished_simulated > 0) words += fmt::format(", {} simulated", now.finished_simulated);
  return words;
}

std::string clock_words(std::int64_t t_us) {
  const std::int64_t seconds = t_us / 1'000'000;
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace promenade::app
