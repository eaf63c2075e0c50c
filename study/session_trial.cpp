// The running trial: what is shown, what is logged, and when it is over.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/session_steps.h"
#include "study/stimulus.h"

namespace promenade::study {
namespace {

using Json = nlohmann::ordered_json;

// What is rated has nothing to touch.
class NoControls final : public InterfaceState {
 public:
  explicit NoControls(Eigen::VectorXd weights) : weights_(std::move(weights)) {}
  std::unique_ptr<InterfaceState> clone() const override {
    return std::make_unique<NoControls>(*this);
  }
  Applied apply(const ControlInput&) override { return Applied::refused; }
  void weights(std::int64_t, Eigen::VectorXd& weights) const override { weights = weights_; }

 private:
  Eigen::VectorXd weights_;
};

void measure(const motion::PoseBank& bank, motion::DistanceTimes times, TrialState& trial) {
  motion::set_weights(bank, trial.weights, trial.blend);
  motion::blended_cycle(bank, trial.blend, trial.cycle);
  motion::distance_points(bank, trial.blend, trial.points, times);
  if (!trial.target_points) return;
  const motion::Distance d = motion::distance(*trial.target_points, trial.points);
  TrialEnded& summary = trial.summary;
  trial.d = d.mean_m;
  summary.d_best = std::min(summary.d_best.value_or(d.mean_m), d.mean_m);
  summary.d_final = d.mean_m;
  summary.d_sum = d.sum_m;
  summary.seconds_difference = trial.cycle.seconds - trial.target->seconds;
}

std::optional<double> logged(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

// What a replay and a reader of the log need to know of an input beside its columns.
std::string control_json(const ControlInput& input, Applied applied, bool first) {
  Json json = {{"applied", applied != Applied::refused}};
  if (first) json["first"] = true;
  if (!input.text.empty()) json["text"] = input.text;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string controls_json(const InterfaceState& interface) {
  const std::vector<ControlInput> settings = interface.settings();
  if (settings.empty()) return "";
  Json controls = Json::array();
  for (const ControlInput& setting : settings) {
    Json one = {{"kind", setting.kind}, {"target", setting.target}};
    if (!std::isnan(setting.value)) one["value"] = setting.value;
    if (!std::isnan(setting.x)) one["x"] = setting.x;
    if (!std::isnan(setting.y)) one["y"] = setting.y;
    controls.push_back(std::move(one));
  }
  return Json{{"controls", controls}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Which walk through its graph was shown: a later program may find another one.
std::string stimulus_json(const Stimulus& stimulus) {
  return Json{{"stimulus", {{"seconds", stimulus.seconds()}, {"edges", stimulus.edges}}}}.dump();
}

}  // namespace

const Task& Session::Steps::task() const {
  return task_of(session.bundle_->study,
                 session.plan_.trials[static_cast<std::size_t>(session.trial_->index)]);
}

// Only what a person did can win.
bool Session::Steps::below_threshold(const TrialState& trial) const {
  const std::optional<double>& threshold =
      task_of(session.bundle_->study, session.plan_.trials[static_cast<std::size_t>(trial.index)])
          .threshold_m;
  return trial.touched && trial.d && threshold && *trial.d < *threshold;
}

// The state in which the trial begins: the average, or the end of its guess.
void Session::Steps::reset_trial(TrialState& trial, std::int64_t t_us) const {
  const StudyBundle& bundle = *session.bundle_;
  const PlannedTrial& planned = session.plan_.trials[static_cast<std::size_t>(trial.index)];
  trial.touched = false;
  trial.below_since_us.reset();
  trial.weights = start_weights(bundle.space);
  if (planned.interface < 0) {
    if (!trial.stimulus) trial.weights = *target_weights(bundle.study, planned);
    trial.interface = std::make_unique<NoControls>(trial.weights);
    return;
  }
  if (const InterfaceState* guess = guess_of(trial.index)) {
    trial.interface = guess->clone();
    trial.touched = true;
    trial.interface->weights(trial.control_us(t_us), trial.weights);
    return;
  }
  const InterfaceUse& use = bundle.study.interfaces[static_cast<std::size_t>(planned.interface)];
  const InterfaceType* type = session.registry_->find(use.type);
  const auto number = static_cast<std::uint64_t>(trial.index);
  trial.interface = type->start({bundle.space, use.parameters, trial.weights,
                                 Rng(session.plan_.seed, number, "interface").next(), use.model});
}

TrialState Session::Steps::fresh_trial(int index, std::int64_t t_us) const {
  const StudyBundle& bundle = *session.bundle_;
  TrialState trial;
  trial.index = index;
  trial.started_us = t_us;
  const PlannedTrial& planned = session.plan_.trials[static_cast<std::size_t>(index)];
  const Task& task = task_of(bundle.study, planned);
  if (has_target_motion(task.kind)) {
    trial.target = motion::blend(bundle.space, *target_weights(bundle.study, planned));
    trial.target_points = motion::distance_points(bundle.space.set, *trial.target, task.distance);
  }
  trial.stimulus = target_of(bundle.study, planned).stimulus.get();
  trial.showing.since_us = t_us;
  trial.blend = motion::make_pose_blend(bundle.bank);
  reset_trial(trial, t_us);
  measure(bundle.bank, task.distance, trial);
  trial.summary.trial = index;
  trial.process.begin(t_us);
  if (trial.stimulus) return trial;
  trial.process.shown(t_us, trial.d, 0, trial.weights, bundle.coverage, false);
  return trial;
}

void Session::Steps::begin_trial(std::int64_t t_us) {
  session.trial_ = fresh_trial(session.page().trial, t_us);
  TrialState& trial = *session.trial_;
  trial.attempt = ++session.attempts_[static_cast<std::size_t>(trial.index)];
  session.last_begun_ = trial.index;
  records.emplace_back(TrialStarted{trial.index, t_us, trial.d, trial.attempt});
  log_system("start", t_us).detail =
      trial.stimulus ? stimulus_json(*trial.stimulus) : controls_json(*trial.interface);
  // No weights make a stimulus.
  if (!trial.stimulus) records.emplace_back(Sample{trial.index, t_us, trial.d, trial.weights});
}

void Session::Steps::open_trial(std::int64_t t_us) {
  begin_trial(t_us);
  open_questions();
  if (!below_threshold(*session.trial_)) return;
  // Its guess has won already: a success at T = 0 (ours).
  session.trial_->summary.first_below_us = t_us;
  log_system("won_by_guess", t_us);
  end_trial(t_us, TrialOutcome::success);
  session.just_ended_.reset();
  leave_trial(t_us);
}

// Shows the weights that the trial has now. A change by time alone (an interface that
// glides) leaves the dwell time running while D stays below.
void Session::Steps::show(TrialState& trial, std::int64_t t_us, Shown how) {
  if (trial.stimulus) return;
  const motion::DistancePoints before = trial.points;
  measure(session.bundle_->bank, task().distance, trial);
  records.emplace_back(Sample{trial.index, t_us, trial.d, trial.weights});
  trial.process.shown(trial.control_us(t_us), trial.d,
                      motion::distance(before, trial.points).mean_m, trial.weights,
                      session.bundle_->coverage, how == Shown::gesture);
  const bool below = below_threshold(trial);
  if (!below) {
    trial.below_since_us.reset();
  } else if (how != Shown::time || !trial.below_since_us) {
    trial.below_since_us = t_us;
  }
  if (below && !trial.summary.first_below_us) trial.summary.first_below_us = t_us;
}

void Session::Steps::end_trial(std::int64_t t_us, TrialOutcome outcome) {
  TrialEnded ended = session.trial_->summary;
  const int index = ended.trial;
  ended.t_us = t_us;
  ended.outcome = outcome;
  ended.process = session.trial_->process.at(session.trial_->control_us(t_us));
  session.just_ended_.reset();
  if (!task().blind) session.just_ended_ = {index, outcome};
  // An untouched guess is no other start than the average.
  const bool kept = outcome != TrialOutcome::skipped && outcome != TrialOutcome::aborted;
  const bool guessed = kept && task().kind == TaskKind::guess && session.trial_->touched;
  if (guessed) session.guesses_[index] = std::move(session.trial_->interface);
  session.outcomes_[index] = outcome;
  keep_answers();
  session.trial_.reset();
  records.emplace_back(ended);
}

void Session::Steps::pass_deadlines(std::int64_t t_us) {
  while (session.trial_) {
    const TrialState& trial = *session.trial_;
    constexpr std::int64_t never = INT64_MAX;
    // Whoever works blind learns nothing from the end of the trial before Done.
    const bool ends_itself = trial.below_since_us && !task().blind;
    const std::int64_t won = ends_itself ? *trial.below_since_us + task().dwell_us : never;
    const std::optional<double>& limit = task().limit_s;
    const std::int64_t over =
        limit ? trial.started_us + trial.summary.paused_us + static_cast<std::int64_t>(*limit * 1e6)
              : never;
    if (std::min(won, over) > t_us) return;
    log_system(won <= over ? "won" : "timeout", std::min(won, over));
    emit_answers();
    end_trial(std::min(won, over), won <= over ? TrialOutcome::success : TrialOutcome::timeout);
    next_page(std::min(won, over));
  }
}

void Session::Steps::act(const Tick&) {
  if (!session.trial_ || !session.trial_->touched) return;
  TrialState& trial = *session.trial_;
  trial.interface->weights(trial.control_us(input.t_us), trial.next);
  if (trial.next == trial.weights) return;
  trial.weights.swap(trial.next);
  show(trial, input.t_us, Shown::time);
}

void Session::Steps::act(const Wait&) {}

void Session::Steps::act(const Press&) {
  Event& event = log("press");
  event.x = input.x;
  event.y = input.y;
  end_gesture();
  if (session.trial_ && input.actor == Actor::participant) ++session.trial_->summary.clicks;
}

void Session::Steps::act(const Done&) {
  if (!session.trial_) return;
  if (!task().has_done || !session.answered()) {
    log("done_refused");
    return;
  }
  log("done");
  emit_answers();
  const bool won = below_threshold(*session.trial_);
  end_trial(input.t_us, won ? TrialOutcome::success : TrialOutcome::done);
  next_page(input.t_us);
}

void Session::Steps::act(const StartOver&) {
  if (!session.trial_) return;
  log("start_over");
  TrialState& trial = *session.trial_;
  end_gesture();
  remember({.kind = "start_over", .target = ""}, std::move(trial.interface), trial.touched);
  reset_trial(trial, input.t_us);
  show(trial, input.t_us, Shown::gesture);
}

void Session::Steps::act(const Control& control) {
  if (!session.trial_) return;
  TrialState& trial = *session.trial_;
  ControlInput change = control.input;
  change.t_us = trial.control_us(input.t_us);
  std::unique_ptr<InterfaceState> before = before_gesture(change);
  const bool goes_on = before == nullptr;
  const Applied applied = trial.interface->apply(change);
  Event& event = log(change.kind.c_str());
  event.target = change.target;
  event.value = logged(change.value);
  event.x = logged(change.x);
  event.y = logged(change.y);
  const bool first = applied == Applied::done && input.actor == Actor::participant &&
                     trial.first_touched.insert(change.kind + " " + change.target).second;
  event.detail = control_json(change, applied, first);
  if (applied != Applied::done) return;
  remember(change, std::move(before), trial.touched);
  if (goes_on && !trial.history.dragged) trial.process.drag();
  trial.history.dragged = goes_on;
  trial.process.touched(static_cast<int>(trial.first_touched.size()));
  trial.interface->weights(change.t_us, trial.next);
  // The first touch counts even where it shows the start: from now on it can win.
  const bool changes = trial.next != trial.weights;
  const bool shows = !trial.touched || changes;
  trial.touched = true;
  // A drag is one change, however many frames it took.
  const bool gesture = changes && input.actor == Actor::participant && !trial.history.counted;
  if (gesture) {
    trial.history.counted = true;
    ++trial.summary.changes;
  }
  if (!shows) return;
  trial.weights.swap(trial.next);
  show(trial, input.t_us, gesture ? Shown::gesture : Shown::control);
}

void Session::Steps::act(const Camera& camera) {
  if (session.trial_) session.trial_->process.camera(session.trial_->control_us(input.t_us));
  log("camera").detail =
      fmt::format(R"({{"yaw":{},"pitch":{},"zoom":{},"right":{},"up":{}}})", camera.yaw,
                  camera.pitch, camera.zoom, camera.right, camera.up);
}

void Session::Steps::act(const Playback& playback) {
  Event& event = log("playback");
  event.target = playback.playing ? "play" : "pause";
  event.value = playback.speed;
  if (playback.phase >= 0) event.detail = fmt::format(R"({{"phase":{}}})", playback.phase);
  if (!session.trial_ || !session.trial_->stimulus) return;
  StimulusClock& showing = session.trial_->showing;
  const std::int64_t now_us = session.trial_us(input.t_us);
  const double at_s = playback.phase >= 0 ? playback.phase * session.trial_->stimulus->seconds()
                                          : showing.seconds(now_us);
  showing = {playback.playing, playback.speed, at_s, now_us};
}

void Session::Steps::act(const LateFrame& late) {
  Event& event = log("late_frame");
  event.actor = Actor::system;
  event.value = static_cast<double>(late.late_us);
  if (session.trial_) ++session.trial_->summary.late_frames;
}

}  // namespace promenade::study
