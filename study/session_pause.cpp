// A pause: nothing that is shown can be touched, no clock runs, and afterwards everything
// goes on as if the time between had not been.
#include "study/session_steps.h"

namespace promenade::study {

bool Session::Steps::stands() const {
  return session.paused() && !std::holds_alternative<Resume>(input.action) &&
         !std::holds_alternative<Stop>(input.action);
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
