// What leaves the planned order of the pages: practice to a criterion, trials that a guess
// has won, what the experimenter skips or repeats, and going on after an interruption.
#include <algorithm>
#include <utility>

#include "study/session_steps.h"

namespace promenade::study {
namespace {

bool opens_trial(const Page& page) {
  return page.kind == PageKind::instructions || page.kind == PageKind::intro;
}

bool is_between(const Page& page) {
  return page.kind == PageKind::questionnaire || page.kind == PageKind::release ||
         page.kind == PageKind::break_;
}

// Is it a page of this trial alone: its introduction, itself, the questions about it?
bool belongs_to(const Study& study, const Page& page, int trial) {
  if (page.trial != trial) return false;
  if (page.kind == PageKind::trial || opens_trial(page)) return true;
  return page.kind == PageKind::questionnaire &&
         study.questionnaires[static_cast<std::size_t>(page.questionnaire)].when ==
             Questionnaire::When::trial;
}

std::size_t opening_page(const Plan& plan, int trial) {
  const auto found = std::find_if(plan.pages.begin(), plan.pages.end(), [trial](const Page& page) {
    return page.trial == trial && opens_trial(page);
  });
  return static_cast<std::size_t>(found - plan.pages.begin());
}

constexpr std::string_view policy_words[] = {"continue", "trial", "block"};

}  // namespace

bool Session::can_skip() const {
  return page().kind == PageKind::trial || opens_trial(page()) || is_between(page());
}

std::string_view to_text(ResumePolicy policy) {
  return policy_words[static_cast<std::size_t>(policy)];
}

ResumePolicy resume_policy_of(std::string_view word) {
  const auto found = std::find(std::begin(policy_words), std::end(policy_words), word);
  return found == std::end(policy_words)
             ? ResumePolicy::continue_
             : static_cast<ResumePolicy>(found - std::begin(policy_words));
}

void Session::Steps::go_to(std::size_t page, std::int64_t t_us) {
  session.page_ = page;
  pass_won_trials(t_us);
  open_page(t_us);
}

void Session::Steps::leave_trial(std::int64_t t_us) {
  const int trial = session.page().trial;
  if (repeat_practice(t_us)) return;
  const std::vector<Page>& pages = session.plan_.pages;
  std::size_t next = session.page_ + 1;
  while (belongs_to(session.bundle_->study, pages[next], trial)) ++next;
  go_to(page_behind(next - 1), t_us);
}

// The next one; behind a guess that was done again, the trial that it had won.
std::size_t Session::Steps::page_behind(std::size_t page) {
  const std::size_t next = page + 1;
  if (session.back_to_ < 0) return next;
  if (belongs_to(session.bundle_->study, session.plan_.pages[next], session.last_begun_)) {
    return next;
  }
  return opening_page(session.plan_, std::exchange(session.back_to_, -1));
}

int Session::Steps::guess_index(int trial) const {
  const std::vector<PlannedTrial>& trials = session.plan_.trials;
  const PlannedTrial& asked = trials[static_cast<std::size_t>(trial)];
  const int guess = task_of(session.bundle_->study, asked).start_guess;
  if (guess < 0) return -1;
  for (const auto& [index, state] : session.guesses_) {
    const PlannedTrial& guessed = trials[static_cast<std::size_t>(index)];
    if (guessed.task == guess && guessed.interface == asked.interface &&
        guessed.target == asked.target && guessed.practice == asked.practice) {
      return index;
    }
  }
  return -1;
}

const InterfaceState* Session::Steps::guess_of(int trial) const {
  const int index = guess_index(trial);
  return index < 0 ? nullptr : session.guesses_.at(index).get();
}

bool Session::Steps::guess_wins(int trial, std::int64_t t_us) const {
  return guess_of(trial) != nullptr && below_threshold(fresh_trial(trial, t_us));
}

// There is nothing to introduce.
void Session::Steps::pass_won_trials(std::int64_t t_us) {
  const Page& page = session.plan_.pages[session.page_];
  if (opens_trial(page) && guess_wins(page.trial, t_us)) ++session.page_;
}

// Practice that is not good enough begins anew, a few times. What has no threshold is good
// when it was done.
bool Session::Steps::repeat_practice(std::int64_t t_us) {
  const Practice& rule = session.bundle_->study.practice;
  const std::vector<PlannedTrial>& trials = session.plan_.trials;
  const Page& page = session.page();
  if (rule.until != Practice::Until::criterion || page.kind != PageKind::trial) return false;
  if (session.back_to_ >= 0) return false;  // it was judged before
  const PlannedTrial& last = trials[static_cast<std::size_t>(page.trial)];
  const auto with_it = [&last](const PlannedTrial& trial) {
    return trial.practice && trial.block == last.block;
  };
  const std::size_t next = static_cast<std::size_t>(page.trial) + 1;
  const bool goes_on = next < trials.size() && with_it(trials[next]);
  if (!last.practice || goes_on) return false;
  int first = page.trial, wanted = 0, good = 0;
  for (int i = page.trial; i >= 0 && with_it(trials[static_cast<std::size_t>(i)]); --i) {
    first = i;
    ++wanted;
    const bool free =
        !task_of(session.bundle_->study, trials[static_cast<std::size_t>(i)]).threshold_m;
    const auto outcome = session.outcomes_.find(i);
    if (outcome == session.outcomes_.end()) continue;
    if (outcome->second == TrialOutcome::skipped) return false;  // the experimenter's word
    good +=
        outcome->second == TrialOutcome::success || (free && outcome->second == TrialOutcome::done);
  }
  const bool enough = good >= std::min(rule.successes, wanted);
  const bool over = enough || ++session.practice_rounds_ >= rule.most_rounds;
  Event& event = log_system(over ? "practice_over" : "practice_again", t_us);
  event.value = good;
  event.target = enough ? "criterion" : "rounds";
  if (over) session.practice_rounds_ = 0;
  if (over) return false;
  for (int i = first; i <= page.trial; ++i) supersede(i, t_us);
  session.last_begun_ = first;
  go_to(opening_page(session.plan_, first), t_us);
  return true;
}

void Session::Steps::supersede(int trial, std::int64_t t_us) {
  if (session.outcomes_.count(trial) == 0) return;  // not begun, or begun and taken back
  records.emplace_back(TrialSuperseded{trial, t_us});
  session.guesses_.erase(trial);
  session.outcomes_.erase(trial);
  session.kept_.erase(trial);
}

// What its guess has won cannot go otherwise as long as the guess stays. What stands in the
// plan between the two is left as it is.
void Session::Steps::repeat(bool block, bool with_guess) {
  const std::vector<PlannedTrial>& trials = session.plan_.trials;
  const int begun = session.last_begun_;
  if (begun < 0) return;
  if (session.trial_) end_trial(input.t_us, TrialOutcome::aborted);
  session.just_ended_.reset();
  if (!block && with_guess) {
    session.back_to_ = begun;
    session.last_begun_ = guess_index(begun);
    supersede(begun, input.t_us);
    supersede(session.last_begun_, input.t_us);
    return go_to(opening_page(session.plan_, session.last_begun_), input.t_us);
  }
  const int last = block ? std::max(begun, std::exchange(session.back_to_, -1)) : begun;
  int first = begun;
  const auto block_of = [&trials](int trial) {
    return trials[static_cast<std::size_t>(trial)].block;
  };
  while (block && first > 0 && block_of(first - 1) == block_of(begun)) --first;
  for (int i = first; i <= last; ++i) supersede(i, input.t_us);
  session.last_begun_ = first;
  if (block) session.practice_rounds_ = 0;
  go_to(opening_page(session.plan_, first), input.t_us);
}

// Has the block of the last trial begun and not ended?
bool Session::Steps::within_block() const {
  const std::vector<PlannedTrial>& trials = session.plan_.trials;
  const int last = session.last_begun_;
  if (last < 0) return false;
  const auto next = static_cast<std::size_t>(last) + 1;
  return session.trial_ || (next < trials.size() &&
                            trials[next].block == trials[static_cast<std::size_t>(last)].block);
}

void Session::Steps::act(const Note& note) { log("note").detail = json_text("text", note.text); }

void Session::Steps::act(const Refused& refused) {
  Event& event = log("request_refused");
  event.target = refused.what;
  event.detail = json_text("why", refused.why);
}

void Session::Steps::act(const Release&) {
  if (session.page().kind != PageKind::release) return;
  log("release");
  next_page(input.t_us);
}

void Session::Steps::act(const Skip& skip) {
  if (!session.can_skip()) return;
  log("skip").detail = json_text("reason", skip.reason);
  emit_answers();
  if (is_between(session.page())) return next_page(input.t_us);
  if (!session.trial_) {
    ++session.page_;
    begin_trial(input.t_us);
  }
  end_trial(input.t_us, TrialOutcome::skipped);
  leave_trial(input.t_us);
}

void Session::Steps::act(const Repeat& what) {
  if (session.last_begun_ < 0) return;
  const bool won = !session.trial_ && guess_wins(session.last_begun_, input.t_us);
  const bool with_guess = !what.block && what.with_guess && won;
  Event& event = log("repeat");
  event.target = what.block ? "block" : with_guess ? "guess" : "trial";
  event.detail = json_text("reason", what.reason);
  repeat(what.block, with_guess);
}

// Between two blocks nothing is begun anew.
void Session::Steps::act(const Interrupted& gap) {
  Event& event = log("interrupted");
  event.value = 1e-6 * static_cast<double>(gap.gap_us);
  event.target = to_text(gap.policy);
  if (session.left()) return;  // nobody was there to be interrupted
  const bool redo_trial = gap.policy == ResumePolicy::redo_trial && session.trial_;
  const bool redo_block = gap.policy == ResumePolicy::redo_block && within_block();
  if (redo_trial || redo_block) {
    wake();
    return repeat(redo_block, false);
  }
  if (session.paused() || session.ended()) return;
  end_gesture();
  session.paused_since_us_ = input.t_us;
}

}  // namespace promenade::study
