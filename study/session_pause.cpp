// A pause: nothing that is shown can be touched, no clock runs, and afterwards everything
// goes on as if the time between had not been.
#include "study/session_steps.h"

namespace promenade::study {

bool Session::Steps::rests() const {
  if (!session.paused()) return false;
  return std::holds_alternative<Note>(input.action) ||
         std::holds_alternative<Refused>(input.action) ||
         std::holds_alternative<Interrupted>(input.action);
}

bool Session::Steps::stands() const {
  const auto ends_it = [](const auto& action) {
    using Action = std::decay_t<decltype(action)>;
    return std::is_same_v<Action, Resume> || std::is_same_v<Action, Stop> ||
           std::is_same_v<Action, Skip> || std::is_same_v<Action, Repeat> ||
           std::is_same_v<Action, Release>;
  };
  if (session.left()) return !std::holds_alternative<Return>(input.action);
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

// Between two tasks, where nothing is half done.
bool Session::can_leave() const {
  const PageKind kind = page().kind;
  return bundle_->study.safety.leave && !ended() && !paused() &&
         (kind == PageKind::instructions || kind == PageKind::intro || kind == PageKind::break_);
}

void Session::Steps::act(const Leave&) {
  if (!session.can_leave()) return;
  log("leave");
  session.paused_since_us_ = input.t_us;
  session.left_ = true;
}

void Session::Steps::act(const Return& gap) {
  if (!session.left()) return;
  session.left_ = false;
  log("return").value = 1e-6 * static_cast<double>(gap.gap_us);
}

}  // namespace promenade::study
