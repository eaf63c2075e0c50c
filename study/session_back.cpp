// The way back in a rate task: to the motion before, with its answers. Whoever has seen more
// motions may find that the first ones were judged too boldly.
#include "study/session_steps.h"

namespace promenade::study {

// Free only within a task, among practice or among what counts, where the motion before was
// answered as it should be and nothing stands between the two: no break, no other questions.
// With a limit it would give time that others do not have.
int Session::trial_before() const {
  const Page& now = page();
  const bool on_trial = now.kind == PageKind::trial;
  if ((!on_trial && now.kind != PageKind::intro) || now.trial < 1 || back_to_ >= 0) return -1;
  const int before = now.trial - 1;
  const PlannedTrial& here = plan_.trials[static_cast<std::size_t>(now.trial)];
  const PlannedTrial& there = plan_.trials[static_cast<std::size_t>(before)];
  const Task& task = task_of(bundle_->study, here);
  const bool same = there.task == here.task && there.practice == here.practice;
  if (task.kind != TaskKind::rate || task.limit_s || !same) return -1;
  const std::size_t opening = page_ - (on_trial ? 1 : 0);
  const Page& left = plan_.pages[opening - 1];
  if (left.kind != PageKind::trial || left.trial != before) return -1;
  const auto outcome = outcomes_.find(before);
  return outcome != outcomes_.end() && outcome->second == TrialOutcome::done ? before : -1;
}

bool Session::can_go_back() const { return !ended() && trial_before() >= 0; }

// What was answered of a motion is filled in when its page opens again.
void Session::Steps::keep_answers() {
  if (task().kind != TaskKind::rate) return;
  session.kept_[session.trial_->index] = {session.answers_, session.answered_us_};
}

void Session::Steps::fill_in() {
  const Page& page = session.page();
  if (page.kind != PageKind::trial) return;
  const auto kept = session.kept_.find(page.trial);
  if (kept == session.kept_.end() || kept->second.answers.size() != session.answers_.size()) return;
  session.answers_ = kept->second.answers;
  session.answered_us_ = kept->second.answered_us;
}

// It counts as if it had not been begun, but for what was answered.
void Session::Steps::reopen(int trial) {
  const auto kept = session.kept_.find(trial);
  const bool had = kept != session.kept_.end();
  const KeptAnswers answers = had ? kept->second : KeptAnswers{};
  supersede(trial, input.t_us);
  if (had) session.kept_[trial] = answers;
}

void Session::Steps::act(const Back&) {
  const int before = session.trial_before();
  if (before < 0) return;
  const std::size_t opening = session.page_ - (session.trial_ ? 1 : 0);
  log("back");
  if (session.trial_) {
    const int here = session.trial_->index;
    end_trial(input.t_us, TrialOutcome::aborted);
    reopen(here);
  }
  session.just_ended_.reset();
  reopen(before);
  go_to(opening - 1, input.t_us);
}

}  // namespace promenade::study
