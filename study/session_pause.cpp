// A pause: nothing that is shown can be touched, no clock runs, and afterwards everything
// goes on as if the time between had not been.
#include "study/session_steps.h"

namespace promenade::study {

bool Session::Steps::rests() const {
  if (!session.paused()) return false;
  return std::holds_alternative<Note>(input.action) ||
         std::holds_alternative<Interrupted>(input.action);
}

bool Session::Steps::stands() const {
  const auto ends_it = [](const auto& action) {
    using Action = std::decay_t<decltype(action)>;
    return std::is_same_v<Action, Resume> || std::is_same_v<Action, Stop> ||
           std::is_same_v<Action, Skip> || std::is_same_v<Action, Repeat> ||
           std::is_same_v<Action, Release>;
  };
  return session.paused() && !std::visit(ends_it, input.action);
}

void Session::Steps::wake() {
  if (!session.paused()) return;
  const std::int64_t stood_us = input.t_us - *session.paused_since_us_;
  session.paused_since_us_.reset();
  if (std::holds_alternative<Resume>(input.action)) log("resume");
  session.opened_us_ += stood_us;
  if (!session.trial_) return;
  TrialState& trial = *session.trial_;
  trial.summary.paused_us += stood_us;
  if (trial.below_since_us) *trial.below_since_us += stood_us;
}

void Session::Steps::act(const Pause&) {
  log("pause");
  end_gesture();
  session.paused_since_us_ = input.t_us;
}

void Session::Steps::act(const Resume&) {}  // wake() came before

}  // namespace promenade::study
