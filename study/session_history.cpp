// Undo and redo in the running trial. The log has every input, so a replay meets the
// same states.
#include <cmath>

#include "study/session_steps.h"

namespace promenade::study {
namespace {

constexpr std::size_t most_steps = 200;
constexpr std::int64_t longest_rest_us = 1'000'000;  // between two inputs of one gesture

}  // namespace

void Session::Steps::end_gesture() {
  if (session.trial_) session.trial_->history.gesture.clear();
}

// The controls before `next` if undo is to come back to them: not within a gesture.
std::unique_ptr<InterfaceState> Session::Steps::before_gesture(const ControlInput& next) const {
  const TrialState& trial = *session.trial_;
  // Only what has a place or a text comes in many small inputs.
  const bool gradual = !std::isnan(next.value) || !std::isnan(next.x) || !next.text.empty();
  const bool goes_on = gradual && trial.history.gesture == next.kind + " " + next.target &&
                       input.t_us - trial.history.last_us <= longest_rest_us;
  return goes_on ? nullptr : trial.interface->clone();
}

// After `done` was done.
void Session::Steps::remember(const ControlInput& done, std::unique_ptr<InterfaceState> before,
                              bool touched) {
  History& history = session.trial_->history;
  history.gesture = done.kind + " " + done.target;
  history.last_us = input.t_us;
  if (!before) return;
  history.counted = false;
  history.redo.clear();
  if (history.undo.size() == most_steps) history.undo.erase(history.undo.begin());
  history.undo.push_back({std::move(before), touched});
}

void Session::Steps::step_back(const char* kind, std::vector<History::Step>& from,
                               std::vector<History::Step>& to) {
  const bool applied = !from.empty();
  log(kind).detail = applied ? R"({"applied":true})" : R"({"applied":false})";
  if (!applied) return;
  TrialState& trial = *session.trial_;
  // By the controls, not by the last frame: the time of the event decides.
  const std::int64_t t_us = trial.control_us(input.t_us);
  if (trial.touched) trial.interface->weights(t_us, trial.weights);
  from.back().interface->restored(*trial.interface, trial.weights, t_us);
  to.push_back({std::move(trial.interface), trial.touched});
  trial.interface = std::move(from.back().interface);
  trial.touched = from.back().touched;
  from.pop_back();
  end_gesture();
  if (trial.touched) {
    trial.interface->weights(t_us, trial.weights);
  } else {
    trial.weights = start_weights(session.bundle_->space);
  }
  show(trial, input.t_us, Shown::gesture);
}

void Session::Steps::act(const Undo&) {
  if (!session.trial_) return;
  History& history = session.trial_->history;
  step_back("undo", history.undo, history.redo);
}

void Session::Steps::act(const Redo&) {
  if (!session.trial_) return;
  History& history = session.trial_->history;
  step_back("redo", history.redo, history.undo);
}

}  // namespace promenade::study
